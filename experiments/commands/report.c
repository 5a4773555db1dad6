/* SPDX-License-Identifier: GPL-3.0-or-later */
/* report.c - what a result says in the end. Keeps no state. Start reading at fw_report_result(). */
#include "report.h"

#include "experiments/pictures/plot.h"
#include "experiments/study/interrupt.h"
#include "experiments/study/study.h"
#include "experiments/text/terminal.h"
#include "experiments/text/text.h"
#include "experiments/units/units.h"

#include <math.h>

/* What may be done with a result; for people only, never for a script that reads on. */
static void suggest_next(const fw_scenario *scenario, const char *directory)
{
    if (!fw_terminal_is(stdout) || fw_scenario_is_sweep(scenario)) return;
    printf("next: `fretwork table %s` gives the numbers over time, `fretwork plot %s --help` lists "
           "other pictures, `fretwork cite %s` what to cite\n",
           directory, directory, directory);
}

/* The other solids know no noise. */
static bool has_temperature(const fw_scenario *scenario)
{
    for (int b = 0; b < scenario->body_count; ++b) {
        const fw_material_kind kind = scenario->materials[scenario->bodies[b].material].kind;
        if (kind == FW_MOVABLE_PARTICLES || kind == FW_LINEAR_LATTICE) return true;
    }
    return false;
}

void fw_report_units(FILE *out, const fw_scenario *scenario)
{
    fw_units_list(out, &scenario->units, has_temperature(scenario));
}

void fw_report_certificate(FILE *out, const fw_certificate *certificate)
{
    char line[FW_CERTIFICATE_SIZE];
    fw_certificate_print(certificate, line);
    if (line[0]) fprintf(out, "certificate: %s\n", line);
}

void fw_report_certificate_as_json(fw_json *json, const fw_certificate *certificate)
{
    fw_json_begin(json, "certificate", '{');
    for (int n = 0; n < FW_CERTIFICATE_ITEMS; ++n)
        if (!isnan(certificate->worst[n]))
            fw_json_number(json, fw_certificate_rows[n].name, certificate->worst[n]);
    fw_json_end(json, '}');
}

fw_status fw_report_result(const fw_scenario *scenario, const fw_verdicts *verdicts,
                           const fw_certificate *certificate, const char *warnings,
                           const char *directory, bool no_plot, fw_error *error)
{
    fw_text_print_line(stdout, scenario->title);
    printf("\n");
    fw_verdicts_print(stdout, verdicts);
    if (verdicts->count > 0 && fw_units_given(&scenario->units)) {
        printf("in reduced units; one unit is ");
        fw_report_units(stdout, scenario);
        printf("\n");
    }
    if (certificate) fw_report_certificate(stdout, certificate);
    /* They were said when they came, and belong to what came out. */
    if (warnings) fw_text_print(stdout, warnings);
    if (fw_scenario_is_sweep(scenario)) {
        char name[FW_CASE_NAME];
        fw_scenario_case_name(scenario, 0, name);
        printf("results: %s/%s, and of each case, such as %s/%s\n", directory, FW_SWEEP_FILE,
               directory, name);
    } else {
        printf("results: %s/%s\n", directory, FW_TRAJECTORY_FILE);
        if (scenario->profile.every != 0)
            printf("profile: %s/%s; `fretwork profile %s` prints it\n", directory, FW_PROFILE_FILE,
                   directory);
    }
    fflush(stdout);
    /* The results are whole: whoever interrupts the pictures loses nothing else. */
    fw_interrupt_leave();
    const fw_status signal = fw_interrupt_seen();
    if (signal != FW_OK && !no_plot)
        return fw_fail(error, signal,
                       "interrupted before the pictures; the results are whole, `fretwork plot %s` "
                       "draws them",
                       directory);
    if (!no_plot) FW_TRY(fw_plot_all(directory, stdout, error));
    suggest_next(scenario, directory);
    return fw_verdicts_failed(verdicts) > 0 ? FW_EXPECTATION_FAILED : FW_OK;
}

/* Some cases may have failed: the others have their verdicts and pictures all the same. */
static fw_status report(const fw_sweep *sweep, const fw_scenario *scenario, const char *directory,
                        bool no_plot, fw_status status, fw_error *error)
{
    if (status != FW_DIVERGED) FW_TRY(status);
    fw_error own;
    const fw_status reported =
        fw_report_result(scenario, fw_sweep_verdicts(sweep), NULL, NULL, directory, no_plot, &own);
    if (status != FW_OK) return status;
    *error = own;
    return reported;
}

fw_status fw_report_sweep(fw_sweep *sweep, const fw_scenario *scenario, const char *directory,
                          bool no_plot, fw_error *error)
{
    fw_interrupt_watch();
    const fw_status status = fw_sweep_to_end(sweep, error);
    const int missing = status == FW_OK ? fw_sweep_missing(sweep) : 0;
    if (missing == 0) return report(sweep, scenario, directory, no_plot, status, error);
    printf("%d of %d cases are being run by others; once they are finished, `fretwork collect %s` "
           "makes the table and the pictures\n",
           missing, fw_sweep_case_count(sweep), directory);
    return FW_OK;
}

fw_status fw_report_collected(fw_sweep *sweep, const fw_scenario *scenario, const char *directory,
                              bool no_plot, fw_error *error)
{
    const fw_status status = fw_sweep_collect(sweep, error);
    return report(sweep, scenario, directory, no_plot, status, error);
}
