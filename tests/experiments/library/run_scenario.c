/* SPDX-License-Identifier: GPL-3.0-or-later */
/* run_scenario.c - the first height of libfretwork: an experiment of the catalogue, looked at while
 * it runs. Prints how far the sheet has come and what it has kept of its energy. */
#include <fretwork.h>

#include <stdio.h>

static bool look(fw_simulation *simulation, void *context)
{
    const fw_body_view sheet = fw_simulation_body(simulation, 0);
    double energy[FW_SIMULATION_NUMBERS];
    int count;
    fw_error error;
    (void)context;
    if (fw_simulation_measure(simulation, "energy.sheet", energy, &count, &error) != FW_OK) {
        fprintf(stderr, "%s\n", error.sentence);
        return false;
    }
    printf("step %4lld: first particle of %d at (%.3f, %.3f), energy %.6f\n",
           (long long)fw_simulation_step(simulation), sheet.count, sheet.x[0], sheet.y[0],
           energy[0]);
    return true;
}

int main(void)
{
    const char *const settings[] = {"run.record-every=100"};
    fw_simulation_def def = fw_simulation_def_default();
    fw_simulation *simulation;
    fw_error error;
    int expected = 0, failed = 0;
    def.scenario = "wall-bounce";
    def.settings = settings;
    def.setting_count = 1;
    fw_status status = fw_simulation_create(&simulation, &def, &error);
    if (status == FW_OK) status = fw_simulation_run(simulation, 1000, look, NULL, &error);
    if (status == FW_OK) status = fw_simulation_judge(simulation, &expected, &failed, &error);
    if (status == FW_OK)
        printf("%s: %d of %d expectations hold\n", fw_simulation_title(simulation),
               expected - failed, expected);
    else
        fprintf(stderr, "%s\n", error.sentence);
    fw_simulation_destroy(simulation);
    return (int)status;
}
