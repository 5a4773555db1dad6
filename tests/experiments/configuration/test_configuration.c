/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_configuration.c - places of particles from files of other programs, and what is wrong with
 * some. */
#include "tests/support/laws.h"

#include "experiments/configuration/configuration.h"
#include "tests/support/scratch.h"

#include <stdio.h>
#include <string.h>

static char folder[64];

/* Writes the text, and reads it. */
static fw_status read_text(fw_configuration *found, const char *name, const char *text)
{
    char path[128];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *out = fopen(path, "w");
    assert_non_null(out);
    fputs(text, out);
    fclose(out);
    return fw_configuration_read(found, path, &error);
}

static void assert_particle(const fw_configuration *found, int n, double x, double y,
                            const char *kind)
{
    assert_true(n < found->count);
    assert_true(found->place[n].x == x && found->place[n].y == y);
    assert_string_equal(found->kind[n], kind);
}

static void columns_of_extended_xyz_are_found_by_their_names(void **state)
{
    (void)state;
    fw_configuration found;
    assert_int_equal(
        read_text(&found, "a.extxyz",
                  "2\n"
                  "Lattice=\"9 0 0 0 9 0 0 0 9\" Properties=id:I:1:pos:R:3:species:S:1 "
                  "step=4\n"
                  "1 0.25 -1e-3 7 Cu\n"
                  "2 1 2 7 Zn\n"),
        FW_OK);
    assert_int_equal(found.count, 2);
    assert_particle(&found, 0, .25, -1e-3, "Cu");
    assert_particle(&found, 1, 1, 2, "Zn");
    fw_configuration_clear(&found);
}

static void the_last_frame_of_plain_xyz_counts(void **state)
{
    (void)state;
    fw_configuration found;
    assert_int_equal(
        read_text(&found, "a.xyz", "1\nfirst\nAr 1 1 0\n2\n\nAr 3 4 0 99\r\nNe 5 6 0 99\n\n"),
        FW_OK);
    assert_int_equal(found.count, 2);
    assert_particle(&found, 0, 3, 4, "Ar");
    assert_particle(&found, 1, 5, 6, "Ne");
    fw_configuration_clear(&found);
}

/* Lines in any order: the number of an atom says which it is. */
static void atoms_of_lammps_are_found_in_each_style(void **state)
{
    (void)state;
    static const struct {
        const char *style, *atoms;
    } files[] = {{"", "2 1 3 4 0 # second\n\n1 2 1 2 0\n"},
                 {" # atomic", "2 1 3 4 0 0 0 0\n1 2 1 2 0 0 0 0\n"},
                 {" # charge", "1 2 -0.5 1 2 0\n2 1 0.5 3 4 0\n"},
                 {" # molecular", "1 7 2 1 2 0\n2 7 1 3 4 0\n"},
                 {" # full", "1 7 2 -0.5 1 2 0\n2 7 1 0.5 3 4 0\n"}};
    for (size_t n = 0; n < sizeof files / sizeof *files; ++n) {
        char text[256];
        fw_configuration found;
        snprintf(
            text, sizeof text,
            "2 atoms in words\n\n2 atoms\n2 atom types\n\nMasses\n\n1 1\n2 1\n\nAtoms%s\n\n%s\n"
            "Velocities\n\n1 9 9 0\n2 9 9 0\n",
            files[n].style, files[n].atoms);
        assert_int_equal(read_text(&found, "a.data", text), FW_OK);
        assert_int_equal(found.count, 2);
        assert_particle(&found, 0, 1, 2, "2");
        assert_particle(&found, 1, 3, 4, "1");
        fw_configuration_clear(&found);
    }
}

static void each_fault_of_a_file_has_its_sentence(void **state)
{
    (void)state;
    static const struct {
        const char *name, *text, *sentence;
    } wrong[] = {
        {"a.pdb", "",
         "is of no known kind, expected one that ends in .xyz, .extxyz (extended XYZ), "
         ".data or .lmp (LAMMPS)"},
        {"a.xyz", "", "a.xyz is empty, expected a number of particles"},
        {"a.xyz", "two\n\n", "a.xyz:1: there are 'two' particles, expected 1 to 300000"},
        {"a.xyz", "300001\n\n", "a.xyz:1: there are '300001' particles, expected 1 to 300000"},
        {"a.xyz", "0\n\n", "a.xyz:1: there are '0' particles, expected 1 to 300000"},
        {"a.xyz", "1 2\n\n", "a.xyz:1: expected the number of particles alone on a line"},
        {"a.xyz", "1\n", "a.xyz:1: the file ends after the number of particles"},
        {"a.xyz", "2\n\nCu 0 0 0\n", "a.xyz:3: the file ends after 1 particles, expected 2"},
        {"a.xyz", "1\n\nCu 0 0\n", "a.xyz:3: particle 0 has 3 words, expected 4 or more"},
        {"a.xyz", "1\nProperties=pos:R:3:species:S:1\n0 0 0\n",
         "a.xyz:3: particle 0 has 3 words, expected 4 or more"},
        {"a.xyz", "1\n\nCu 0 nan 0\n", "a.xyz:3: y is 'nan', expected a number"},
        {"a.xyz", "2\n\nCu 0 0 1\nCu 0 0 2\n",
         "a.xyz:4: z is 2, expected 1 as of all before: a plane"},
        {"a.xyz", "1\nProperties=pos:R:2\nCu 0 0 0\n",
         "a.xyz:2: Properties has no 'pos:R:3', the places of the particles"},
        {"a.xyz", "1\nProperties=id:I:4294967297:pos:R:3\n1 0 0 0\n",
         "a.xyz:2: Properties has no 'pos:R:3', the places of the particles"},
        {"a.xyz", "1\nProperties=pos:R\nCu 0 0 0\n",
         "a.xyz:2: Properties ends after 'pos', expected NAME:KIND:WIDTH"},
        {"a.xyz", "1\n\nCu 0x 0 0\n", "a.xyz:3: x is '0x', expected a number"},
        {"a.xyz", "1\n\nCu 0 0 1e999\n", "a.xyz:3: z is '1e999', expected a number"},
        {"a.xyz", "1\nProperties=id:I:wide:pos:R:3\n1 0 0 0\n",
         "a.xyz:2: Properties has no 'pos:R:3', the places of the particles"},
        {"a.xyz", "1\nProperties=id:I:0:pos:R:3\n1 0 0 0\n",
         "a.xyz:2: Properties has no 'pos:R:3', the places of the particles"},
        {"a.data", "t\n0 atoms\n", "a.data:2: there are '0' particles, expected 1 to 300000"},
        {"a.data", "t\n1 atoms\nAtomsX\n", "a.data:3: the file ends without a section 'Atoms'"},
        {"a.data", "t\n1 atoms\nAtoms\n\none 1 0 0 0\n",
         "a.data:5: the number of an atom is 'one', expected each of 1 to 1 once"},
        {"a.data", "t\n1 atoms\nAtoms\n\n0 1 0 0 0\n",
         "a.data:5: the number of an atom is '0', expected each of 1 to 1 once"},
        {"a.data", "t\n2 atoms\nAtoms\n\n1 1 0 y 0\n2 1 0 0 0\n",
         "a.data:5: y is 'y', expected a number"},
        {"a.data", "t\n2 atoms\n", "a.data:2: the file ends without a section 'Atoms'"},
        {"a.data", "t\nAtoms\n", "a.data:2: expected a line 'N atoms' before the atoms"},
        {"a.data", "t\n1 atoms\nAtoms # sphere\n",
         "a.data:3: the style of the atoms is 'sphere', expected atomic, charge, bond, angle, "
         "molecular or full"},
        {"a.data", "t\n2 atoms\nAtoms\n\n1 1 0 0 0\n",
         "a.data:5: the file ends after 1 atoms, expected 2"},
        {"a.data", "t\n2 atoms\nAtoms\n\n1 1 0 0 0\n1 1 0 0 0\n",
         "a.data:6: the number of an atom is '1', expected each of 1 to 2 once"},
        {"a.data", "t\n1 atoms\nAtoms\n\n2 1 0 0 0\n",
         "a.data:5: the number of an atom is '2', expected each of 1 to 1 once"},
        {"a.data", "t\n1 atoms\nAtoms\n\n1 1 0 0\n",
         "a.data:5: an atom has 4 words, expected 5 or 8 of style atomic"},
        {"a.data", "t\n1 atoms\nAtoms # full\n\n1 1 0 0 0 0 0 0\n",
         "a.data:5: an atom has 8 words, expected 7 or 10 of style full"},
        {"a.data", "t\n1 atoms\nAtoms\n\n1 1 1 0 0 0 0\n",
         "a.data:5: an atom has 7 words, expected 5 or 8 of style atomic"}};
    for (size_t n = 0; n < sizeof wrong / sizeof *wrong; ++n) {
        fw_configuration found;
        assert_int_equal(read_text(&found, wrong[n].name, wrong[n].text), FW_BAD_INPUT);
        const char *tail = strstr(error.sentence, wrong[n].sentence);
        if (!tail || strlen(tail) != strlen(wrong[n].sentence))
            fail_msg("'%s', expected '%s'", error.sentence, wrong[n].sentence);
        assert_null(found.place);
    }
}

static void assert_sentence(const char *format)
{
    char sentence[256];
    snprintf(sentence, sizeof sentence, format, folder);
    assert_string_equal(error.sentence, sentence);
}

static void what_is_no_text_is_refused(void **state)
{
    (void)state;
    static const char bytes[] = "1\n\nCu 0\0 0 0\n";
    char path[128];
    fw_configuration found;
    snprintf(path, sizeof path, "%s/zero.xyz", folder);
    FILE *out = fopen(path, "w");
    assert_non_null(out);
    fwrite(bytes, 1, sizeof bytes - 1, out);
    fclose(out);
    assert_int_equal(fw_configuration_read(&found, path, &error), FW_BAD_INPUT);
    assert_sentence("%s/zero.xyz has a byte of 0 in it, expected a text");
    assert_null(found.place);
    snprintf(path, sizeof path, "%s/none.data", folder);
    assert_int_equal(fw_configuration_read(&found, path, &error), FW_BAD_INPUT);
    assert_sentence("cannot open %s/none.data: No such file or directory");
    assert_null(found.place);
}

/* Neither the end of the last line nor words without a meaning are needed. */
static void only_what_has_a_meaning_counts(void **state)
{
    (void)state;
    char text[256] = "1\n\nCu 3 4 0";
    fw_configuration found;
    assert_int_equal(read_text(&found, "a.xyz", text), FW_OK);
    assert_int_equal(found.count, 1);
    assert_particle(&found, 0, 3, 4, "Cu");
    fw_configuration_clear(&found);
    for (int n = 0; n < 60; ++n) strcat(text, " 1");
    assert_int_equal(read_text(&found, "a.xyz", text), FW_OK);
    assert_particle(&found, 0, 3, 4, "Cu");
    fw_configuration_clear(&found);
}

static int make(void **state)
{
    (void)state;
    make_folder(folder, sizeof folder);
    return 0;
}

static int clear(void **state)
{
    (void)state;
    remove_folder(folder);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(columns_of_extended_xyz_are_found_by_their_names),
        cmocka_unit_test(the_last_frame_of_plain_xyz_counts),
        cmocka_unit_test(atoms_of_lammps_are_found_in_each_style),
        cmocka_unit_test(each_fault_of_a_file_has_its_sentence),
        cmocka_unit_test(what_is_no_text_is_refused),
        cmocka_unit_test(only_what_has_a_meaning_counts),
    };
    return cmocka_run_group_tests(tests, make, clear);
}
