/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_export_parts.c - what a result does not hold is in no file of another program, and names
 * that nothing can be made under have their sentence. */
#include "tests/support/laws.h"

#include "experiments/exchange/export.h"
#include "experiments/storage/regular_file.h"
#include "tests/support/program.h"
#include "tests/support/recorded_run.h"

static char folder[64], results[80];

/* One frame of two bodies that have neither masses, velocities, forces, fields nor links. */
static int begin(void **state)
{
    static const fw_trajectory_body bodies[] = {{.name = "gas", .count = 5},
                                                {.name = "wall", .count = 3}};
    fw_trajectory *trajectory;
    fw_trajectory_def def;
    (void)state;
    make_quick_folder(folder, sizeof folder);
    snprintf(results, sizeof results, "%s/bare", folder);
    def = run_def(results);
    def.bodies = bodies;
    def.velocity = def.force = false;
    def.field_count = def.observable_count = 0;
    def.sample_count = 0;
    assert_fine(fw_trajectory_create(&trajectory, &def, &error));
    assert_fine(run_write_frame(trajectory, 0));
    assert_fine(fw_trajectory_finish(trajectory, FW_RUN_FINISHED, &error));
    fw_trajectory_destroy(trajectory);
    return 0;
}

static int end(void **state)
{
    (void)state;
    remove_folder(folder);
    return 0;
}

static fw_status export_as(const char *format, const char *name)
{
    char *made = NULL;
    const fw_export_wish wish = {results, format, name, 1};
    const fw_status status = fw_export(&wish, &made, &error);
    assert_true((made != NULL) == (status == FW_OK));
    free(made);
    return status;
}

/* The text of a file that is made in the folder. */
static const char *exported(const char *format, const char *ending, const char *inside)
{
    static char text[16384];
    char name[128];
    snprintf(name, sizeof name, "%s/bare%s", folder, ending);
    assert_fine(export_as(format, name));
    snprintf(name, sizeof name, "%s/bare%s", folder, inside);
    FILE *file = fopen(name, "r");
    assert_non_null(file);
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    fclose(file);
    return text;
}

static void expect_none(const char *text, const char *const words[])
{
    for (int n = 0; words[n]; ++n)
        if (strstr(text, words[n])) fail_msg("'%s' in %s", words[n], text);
}

static void what_was_not_recorded_is_in_no_file(void **state)
{
    (void)state;
    static const char *const parts[] = {"mass", "Mass", "velocity", "Velocities", "force", NULL};
    const char *text = exported("csv", ".csv", ".csv");
    assert_int_equal(
        strncmp(text, "# a run\nstep,time,id,body,x,y\n0,0,0,gas,0,0.25\n0,0,1,gas,1,1.25\n", 64),
        0);
    expect_none(text, parts);

    text = exported("extxyz", ".extxyz", ".extxyz");
    assert_int_equal(strncmp(text,
                             "8\nProperties=species:S:1:pos:R:3:id:I:1:body:I:1 step=0 time=0 "
                             "pbc=\"F F F\" bodies=\"gas wall\"\nX 0 0.25 0 0 0\nX 1 1.25 0 1 0\n",
                             120),
                     0);
    expect_none(text, parts);

    text = exported("data", ".data", ".data");
    assert_non_null(strstr(text, "8 atoms\n2 atom types\n"));
    assert_non_null(strstr(text, "Atoms # atomic\n\n1 1 0 0.25 0\n"));
    expect_none(text, parts);

    text = exported("vtp", ".pvd", ".frames/frame-000000.vtp");
    assert_non_null(strstr(text, "NumberOfPoints=\"8\" NumberOfVerts=\"8\" NumberOfLines=\"0\""));
    assert_non_null(strstr(text, "Name=\"id\""));
    expect_none(text, parts);

    /* Both names are absolute, and so is that of the results in the description. */
    text = exported("xdmf", ".xdmf", ".xdmf");
    char path[256];
    snprintf(path, sizeof path, ">%s/trajectory.h5:/particles/trajectory/position/value<", results);
    assert_non_null(strstr(text, path));
    assert_non_null(strstr(text, "TopologyType=\"Polyvertex\" NumberOfElements=\"8\""));
    expect_none(text, parts);
}

static void names_that_are_too_long_are_refused(void **state)
{
    (void)state;
    static char name[2 * FW_PATH_SIZE];
    memset(name, 'n', sizeof name);
    strcpy(name + FW_PATH_SIZE - 6, ".pvd");
    assert_refused(export_as("vtp", name), FW_BAD_INPUT, "nnnnn...' is too long");
    assert_int_equal(strncmp(error.sentence, "the name 'nnnnn", 15), 0);

    fw_error sentence;
    char *made;
    memset(name, 'n', sizeof name);
    name[FW_PATH_SIZE] = '\0';
    assert_int_equal(fw_export(&(fw_export_wish){name, "csv", NULL, 1}, &made, &sentence),
                     FW_BAD_INPUT);
    assert_string_equal(sentence.sentence, "the name of the results is too long");
    assert_null(made);
    /* A folder whose file would have too long a name. */
    for (int n = 0; n < FW_PATH_SIZE - 8; ++n) name[n] = n % 2 ? '.' : '/';
    name[FW_PATH_SIZE - 8] = '\0';
    assert_int_equal(fw_export(&(fw_export_wish){name, "csv", NULL, 1}, &made, &sentence),
                     FW_BAD_INPUT);
    assert_non_null(strstr(sentence.sentence, "trajectory.h5 is longer than 4095 bytes"));
    /* One that is no name: the ending would not fit. */
    name[FW_PATH_SIZE - 8] = '/';
    memset(name, 'n', FW_PATH_SIZE - 2);
    name[FW_PATH_SIZE - 2] = '\0';
    assert_int_equal(fw_export(&(fw_export_wish){name, "csv", NULL, 1}, &made, &sentence),
                     FW_BAD_INPUT);
    assert_non_null(strstr(sentence.sentence, "nnnnn...' is too long"));
}

static void frames_have_a_folder_of_their_own(void **state)
{
    (void)state;
    char name[128], sentence[256];
    shell(folder, "touch taken.frames");
    snprintf(name, sizeof name, "%s/taken.pvd", folder);
    snprintf(sentence, sizeof sentence, "cannot open the folder %s/taken.frames: Not a directory",
             folder);
    assert_refused(export_as("vtp", name), FW_BAD_INPUT, sentence);
    assert_false(exists(folder, "taken.pvd"));
    /* A result in which a frame is cut. */
    shell(folder, "cp -r bare cut && truncate -s -3000 cut/trajectory.h5");
    char *made;
    char cut[128];
    snprintf(cut, sizeof cut, "%s/cut", folder);
    snprintf(name, sizeof name, "%s/cut.pvd", folder);
    assert_int_not_equal(fw_export(&(fw_export_wish){cut, "vtp", name, 1}, &made, &error), FW_OK);
    assert_null(made);
    assert_false(exists(folder, "cut.pvd") || exists(folder, "cut.frames"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_was_not_recorded_is_in_no_file),
        cmocka_unit_test(names_that_are_too_long_are_refused),
        cmocka_unit_test(frames_have_a_folder_of_their_own),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
