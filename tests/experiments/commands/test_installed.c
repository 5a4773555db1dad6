/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_installed.c - what `cmake --install` puts in place: program, manual page, completion,
 * catalogue, manual. */
#include "tests/support/laws.h"

#include "experiments/commands/command.h"
#include "experiments/scenario/catalogue.h"
#include "tests/support/program.h"

static char folder[64];

static int install(void **state)
{
    char line[512];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    snprintf(line, sizeof line, "cmake --install \"$(dirname '%s')\" --prefix '%s' > /dev/null",
             FW_PROGRAM, folder);
    shell(folder, line);
    return 0;
}

static int clean(void **state)
{
    (void)state;
    remove_folder(folder);
    return 0;
}

static void everything_is_in_its_place(void **state)
{
    char line[256];
    (void)state;
    for (const fw_catalogue_entry *e = fw_catalogue; e->name; ++e) {
        /* Behind a line with formulas stand their values. */
        snprintf(line, sizeof line,
                 "bin/fretwork show %s | sed 's/  # = [-0-9., e]*$//' | "
                 "cmp - share/fretwork/catalogue/%s.yaml",
                 e->name, e->name);
        shell(folder, line);
    }
    shell(folder, "cd share/doc/fretwork && test -s README.md -a -s LICENSE -a -s CITATION.cff -a "
                  "-s CHANGELOG.md -a -s manual/README.md -a -s manual/commands.md");
    shell(folder,
          "cd share/doc/fretwork && cmp -s README.md manual/README.md && exit 1; "
          "for page in README.md manual/*.md; do "
          "for link in $(grep -o '](manual/[^)#]*\\|](\\.\\./[^)#]*\\|]([A-Z][^):#]*' $page | "
          "cut -c3-); do test -e $(dirname $page)/$link || { echo $page: $link; exit 1; }; "
          "done; done");
    /* A scenario of the catalogue runs from where it lies. */
    shell(folder, "bin/fretwork check share/fretwork/catalogue/free-particle.yaml > /dev/null");
    /* The program writes its manual page and its completion, and says the same of itself today. */
    shell(folder, "bin/fretwork manual-page | cmp - share/man/man1/fretwork.1 && "
                  "bin/fretwork completion | cmp - share/bash-completion/completions/fretwork");
    /* The version is the same everywhere. */
    shell(folder, "v=$(bin/fretwork --version | cut -d' ' -f2); "
                  "grep -q \"^version: $v\" share/doc/fretwork/CITATION.cff && "
                  "grep -q \"^## $v\" share/doc/fretwork/CHANGELOG.md && "
                  "bin/fretwork cite chain | grep -q \"{$v}\"");
}

static void manual_page_tells_every_command(void **state)
{
    char line[512], left[64];
    (void)state;
    if (system("command -v groff > /dev/null") != 0) skip();
    shell(folder, "test -z \"$(groff -man -Tutf8 -ww -z share/man/man1/fretwork.1 2>&1)\"");
    shell(folder, "groff -man -Tascii -P-cbou share/man/man1/fretwork.1 > page");
    for (const fw_command *c = fw_commands; c->name; ++c) {
        if (c->hidden) continue;
        snprintf(line, sizeof line, "grep -qF '   fretwork %s' page", c->usage);
        shell(folder, line);
        for (int n = 0; c->options[n] && c->options[n] != &fw_option_help; ++n) {
            fw_option_usage(c->options[n], left);
            snprintf(line, sizeof line, "grep -qF -- '       %s' page", left);
            shell(folder, line);
        }
    }
    shell(folder, "grep -q '143  *terminated' page && ! grep -q manual-page page");
}

/* What bash would offer for the last of these words. */
static void expect_offered(const char *words, const char *wanted)
{
    char line[1024];
    snprintf(line, sizeof line,
             "found=$(bash -c 'source share/bash-completion/completions/fretwork; "
             "COMP_WORDS=(fretwork %s); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _fretwork; "
             "echo \"${COMPREPLY[*]}\"'); test \"$found\" = '%s' || { echo \"$found\"; false; }",
             words, wanted);
    shell(folder, line);
}

static void bash_completes_words(void **state)
{
    (void)state;
    if (system("command -v bash > /dev/null") != 0) skip();
    shell(folder, "mkdir results && : > results/my.yaml");
    expect_offered("re", "rerun resume report reference");
    expect_offered("run wall-", "wall-bounce");
    expect_offered("run results/m", "results/my.yaml");
    expect_offered("run x --se", "--set --seed");
    expect_offered("run --set run.st", "run.steps=");
    expect_offered("plot results --kind mo", "motion");
    expect_offered("profile results --axis \"\"", "x y");
    expect_offered("resume resu", "results");
    expect_offered("quantities momentum-r", "momentum-ratio");
    expect_offered("reference walls.NAME.piston.ma", "walls.NAME.piston.mass");
    expect_offered("list --n", "--names");
    /* Hidden commands, and words where there are none. */
    expect_offered("manu", "");
    expect_offered("verify --js", "--json");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(everything_is_in_its_place),
        cmocka_unit_test(manual_page_tells_every_command),
        cmocka_unit_test(bash_completes_words),
    };
    return cmocka_run_group_tests(tests, install, clean);
}
