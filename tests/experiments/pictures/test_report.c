/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_report.c - a report is one page of its own markup, whatever titles say, and shows the
 * numbers of the results: see reported.py. */
#include "tests/support/laws.h"

#include "tests/support/program.h"

static const char scenario[] =
    "title: '</script><script>alert(1)</script> & \"more\" <img src=x onerror=alert(2)>'\n"
    "about: \"<b>bold</b> words\"\n"
    "materials: {soft: {lattice-boltzmann: {rest-mass: 0, break-at: .4}}}\n"
    "bodies:\n"
    "  falling: {material: soft, shape: {rectangle: [5, 3]}, origin: [.3, 3.05], velocity: [0, "
    "-.2]}\n"
    "  lying: {material: soft, shape: {rectangle: [5, 3]}}\n"
    "walls: {floor: {chain: [[-5, -.1], [9, -.1]], surface: frictionless}}\n"
    "run: {steps: 40, record-every: 4}\n"
    "record: {force: true, fields: [strain-yy]}\n"
    "measure: [energy, momentum]\n"
    "expect: [{quantity: energy, statistic: largest, above: 0, source: '</td>'}]\n"
    "pictures: {motion: {kind: motion, title: '<i>raised</i>'}}\n";

static const char sweep[] =
    "title: a gas at two temperatures\n"
    "materials: {gas: {movable-particles: {strength: 0}}}\n"
    "bodies: {cloud: {material: gas, shape: {rectangle: [5, 5]}, temperature: 1}}\n"
    "dynamics: {time-step: 0.01, damping: 1, temperature: 0.5}\n"
    "run: {steps: 30, record-every: 10}\n"
    "measure: [energy]\n"
    "expect: [{quantity: energy, statistic: last, above: 0}]\n"
    "study: {sweep: {parameters: {T: {values: [.5, 1]}}, set: ['dynamics.temperature=T']}}\n"
    "pictures: {all: {kind: sweep}}\n";

/* Pulled apart until links between its halves break. */
static const char torn[] =
    "title: a bar is torn\n"
    "units: {length: 0.5 nm, energy: 0.2 eV, mass: 60 u}\n"
    "materials: {glass: {lattice-boltzmann: {damping: 0.05, break-at: 0.1}}}\n"
    "bodies: {bar: {material: glass, shape: {mask: \"###.###\\n#######\\n#######\"}}}\n"
    "forces:\n"
    "  left: {body: bar, sites: left, force: [-0.05, 0]}\n"
    "  right: {body: bar, sites: right, force: [0.05, 0]}\n"
    "run: {steps: 200, record-every: 10}\n"
    "measure: [energy]\n";

/* A lattice has no order of its own: nothing is shown for it. */
static const char mixed[] =
    "title: two kinds\n"
    "materials:\n"
    "  gas: {movable-particles: {strength: 0}}\n"
    "  net: {linear-lattice: {k1: 1, k2: 1}}\n"
    "bodies:\n"
    "  cloud: {material: gas, lattice: hexagonal, shape: {rectangle: [5, 5]}, temperature: 1}\n"
    "  net: {material: net, lattice: hexagonal, shape: {rectangle: [3, 3]}, origin: [20, 0]}\n"
    "dynamics: {time-step: 0.01}\n"
    "run: {steps: 30, record-every: 10}\n"
    "record: {fields: [local-order]}\n"
    "measure: [energy]\n";

/* One of its cases goes out of all bounds. */
static const char failing[] =
    "title: a speck flies\n"
    "about: of two velocities one is hopeless\n"
    "materials: {dust: {lattice-boltzmann: {rest-mass: 1}}}\n"
    "bodies: {speck: {material: dust, shape: {rectangle: [1, 1]}}}\n"
    "run: {steps: 4}\n"
    "measure: [energy]\n"
    "expect: [{quantity: energy, above: 0}]\n"
    "study: {sweep: {parameters: {v: {values: [0.5, 1e6]}}, set: ['bodies.speck.velocity=[v, "
    "0]']}}\n";

static void run_in(char folder[64], const char *text)
{
    make_quick_folder(folder, 64);
    write_scenario(folder, "file.yaml", text);
    const outcome seen = run_program(folder, "run file.yaml -o out --no-plot --quiet");
    expect_end(&seen, 0, "");
}

static void check_page(const char *folder, const char *results, const char *more)
{
    char arguments[256];
    const outcome seen = run_program(folder, "report out -o page.html");
    expect_end(&seen, 0, "");
    assert_non_null(strstr(seen.out, "report: page.html"));
    snprintf(arguments, sizeof arguments, "%s/page.html %s/%s%s", folder, folder, results, more);
    const int status = run_python("reported.py", arguments);
    if (status > 0) fail_msg("the page is not as it should be");
}

static void report_shows_the_results_and_titles_as_text(void **state)
{
    (void)state;
    char folder[64];
    run_in(folder, scenario);
    check_page(folder, "out", "");
    remove_folder(folder);
    skip_unseen();
}

static void report_of_a_sweep_has_its_cases(void **state)
{
    (void)state;
    char folder[64];
    run_in(folder, sweep);
    check_page(folder, "out/T=0.5", "");
    shell(folder,
          "test $(grep -c '\"certificate\"' page.html) = 2; grep -q '\"name\": \"T=1\"' page.html");
    remove_folder(folder);
    skip_unseen();
}

/* In units of nature: lengths by their factor, in nm. */
static void report_shows_when_links_break(void **state)
{
    (void)state;
    char folder[64];
    run_in(folder, torn);
    check_page(folder, "out", " 0.1");
    shell(folder, "grep -q '\"lengthUnit\": \"nm\"' page.html && grep -q '\"lengthFactor\": 0.5,' "
                  "page.html");
    remove_folder(folder);
    skip_unseen();
}

static void report_shows_fields_where_they_are(void **state)
{
    (void)state;
    char folder[64];
    run_in(folder, mixed);
    check_page(folder, "out", "");
    remove_folder(folder);
    skip_unseen();
}

static void report_of_a_sweep_says_what_failed(void **state)
{
    (void)state;
    char folder[64];
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "file.yaml", failing);
    const outcome seen = run_program(folder, "run file.yaml -o out --no-plot --quiet");
    expect_end(&seen, 3, "case v=1000000 of 2 failed");
    check_page(folder, "out/v=0.5", "");
    shell(folder, "grep -q '\"about\": \"of two velocities one is hopeless\"' page.html");
    shell(folder, "grep -q '\"failure\": \"step 2: particle 0 of body speck is at ' page.html");
    shell(folder, "test $(grep -c '\"certificate\"' page.html) = 1");
    remove_folder(folder);
    skip_unseen();
}

static void report_refuses_what_it_cannot_do(void **state)
{
    (void)state;
    static const char *const refused[][2] = {
        {"report out", "expected -o and a name that ends in .html"},
        {"report out -o page.pdf", "page.pdf"},
        {"report nothing -o page.html", "nothing"},
        {"report file.yaml -o page.html", "file.yaml"},
    };
    char folder[64];
    run_in(folder, scenario);
    for (size_t n = 0; n < sizeof refused / sizeof *refused; ++n) {
        const outcome seen = run_program(folder, refused[n][0]);
        expect_end(&seen, 2, refused[n][1]);
        assert_false(exists(folder, "page.html"));
    }
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(report_shows_the_results_and_titles_as_text),
        cmocka_unit_test(report_of_a_sweep_has_its_cases),
        cmocka_unit_test(report_shows_when_links_break),
        cmocka_unit_test(report_shows_fields_where_they_are),
        cmocka_unit_test(report_of_a_sweep_says_what_failed),
        cmocka_unit_test(report_refuses_what_it_cannot_do),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
