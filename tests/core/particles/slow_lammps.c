/* SPDX-License-Identifier: GPL-3.0-or-later */
/* slow_lammps.c - the same positions in LAMMPS (package `lammps`), plainly cut Lennard-Jones:
 * forces agree to 1e-10. Skipped, and said so, where there is no `lmp`. */
#include "tests/support/laws.h"

#include "tests/support/crowd.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { PATH_SIZE = 512 };

static void path_in(char *path, const char *folder, const char *name)
{
    snprintf(path, PATH_SIZE, "%s/%s", folder, name);
}

static FILE *opened(const char *folder, const char *name, const char *mode)
{
    char path[PATH_SIZE];
    path_in(path, folder, name);
    FILE *file = fopen(path, mode);
    assert_non_null(file);
    return file;
}

static void write_input(const char *folder, const fw_crowd *crowd, double cut)
{
    FILE *data = opened(folder, "data", "w");
    fprintf(data,
            "places of a body\n\n%d atoms\n1 atom types\n-50 50 xlo xhi\n-50 50 ylo yhi\n"
            "-0.5 0.5 zlo zhi\n\nMasses\n\n1 1\n\nAtoms\n\n",
            crowd->count);
    for (int i = 0; i < crowd->count; ++i)
        fprintf(data, "%d 1 %.17g %.17g 0\n", i + 1, crowd->at[i].x, crowd->at[i].y);
    fclose(data);
    FILE *input = opened(folder, "in", "w");
    fprintf(input,
            "units lj\ndimension 2\nboundary f f p\natom_style atomic\nread_data %s/data\n"
            "pair_style lj/cut %.17g\npair_coeff 1 1 1 %.17g\n"
            "dump forces all custom 1 %s/forces id fx fy\n"
            "dump_modify forces sort id format float %%.17g\nrun 0\n",
            folder, cut, pow(2, -1. / 6), folder);
    fclose(input);
}

/* 2^(1/6) sigma = r0 makes the two ways to write the potential the same. */
static void forces_are_those_of_lammps(void **state)
{
    (void)state;
    if (system("lmp -help >/dev/null 2>&1") != 0) {
        print_message("no lmp here (Debian package lammps): the comparison is skipped\n");
        skip();
    }
    char folder[] = "/tmp/fretwork-lammps-XXXXXX", command[PATH_SIZE];
    assert_non_null(mkdtemp(folder));
    fw_crowd crowd = crowd_disc(12, (fw_vec2){1, -2}, 0.3, 0.15, 77);
    const double cut = 2.3;
    write_input(folder, &crowd, cut);
    snprintf(command, sizeof command, "lmp -log none -in %s/in >/dev/null 2>&1", folder);
    assert_int_equal(system(command), 0);

    fw_particle_group_def group = fw_particle_group_def_default();
    group.count = crowd.count;
    group.positions = crowd.at;
    fw_particles_def def = fw_particles_def_default();
    def.groups = &group;
    def.group_count = 1;
    def.potential.cut = fw_smooth_cut_over(cut, cut);
    def.overlap_energy = INFINITY;
    fw_solid *solid;
    assert_int_equal(fw_particles_create(&solid, &def, NULL), FW_OK);
    const fw_langevin *langevin = (const fw_langevin *)solid;

    FILE *forces = opened(folder, "forces", "r");
    char line[256];
    while (fgets(line, sizeof line, forces) && strncmp(line, "ITEM: ATOMS", 11) != 0) {
    }
    double largest = 0, worst = 0;
    for (int i = 0; i < solid->count; ++i) {
        int id;
        double x, y;
        assert_int_equal(fscanf(forces, "%d %lf %lf", &id, &x, &y), 3);
        assert_int_equal(id, i + 1);
        largest = fmax(largest, hypot(x, y));
        worst = fmax(worst, hypot(x - langevin->force_x[i], y - langevin->force_y[i]));
    }
    fclose(forces);
    print_message("%d forces up to %.3g differ by at most %.2g\n", solid->count, largest, worst);
    assert_true(largest > 10);
    assert_below(worst / largest, 1e-10);
    fw_solid_destroy(solid);
    free(crowd.at);
    const char *const names[] = {"data", "in", "forces"};
    for (int n = 0; n < 3; ++n) {
        char path[PATH_SIZE];
        path_in(path, folder, names[n]);
        remove(path);
    }
    rmdir(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(forces_are_those_of_lammps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
