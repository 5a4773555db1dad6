/* SPDX-License-Identifier: GPL-3.0-or-later */
/* report_page.c - one page: a frame of HTML, all facts as JSON, and the script that shows them
 * (report.js, report.css). The script makes elements out of texts, never out of markup, so that
 * whatever a title says stays text; the page may fetch nothing.
 * Keeps no state. Start reading at fw_report_make(). */
#include "experiments/pictures/report_page.h"

#include "experiments/storage/whole_file.h"
#include "experiments/study/sweep.h"
#include "experiments/text/xml.h"
#include "report_assets.h"
#include "report_parts.h"

#include <stdlib.h>
#include <string.h>

/* Of the motion of all runs together, before letters make four bytes of three; and what the least
 * run may have. */
#define BUDGET       4e6
#define BUDGET_LEAST 1e5

typedef struct report {
    const fw_report_wish *wish;
    fw_json json;
    size_t budget; /* of each run */
    double kept;   /* the least part of a motion that is in it */
} report;

static fw_status write_run(report *r, const char *name, const char *directory, fw_error *error)
{
    fw_plot_result result;
    double kept = 1;
    fw_status status = fw_plot_result_open(&result, directory, error);
    fw_json_begin(&r->json, NULL, '{');
    if (name) fw_json_text(&r->json, "name", name);
    if (status == FW_OK) status = fw_report_facts(&r->json, &result, r->wish->cite, error);
    if (status == FW_OK) status = fw_report_motion(&r->json, &result, r->budget, &kept, error);
    if (status == FW_OK) status = fw_report_pictures(&r->json, directory, result.scenario, error);
    fw_json_end(&r->json, '}');
    fw_plot_result_close(&result);
    if (kept < r->kept) r->kept = kept;
    return status;
}

static fw_status write_cases(report *r, const fw_scenario *sweep, fw_error *error)
{
    char name[FW_CASE_NAME], path[FW_PATH_SIZE];
    fw_sweep_table table;
    FW_TRY(
        fw_sweep_table_read(&table, r->wish->directory, sweep->study.sweep.parameter_count, error));
    fw_status status = FW_OK;
    for (int n = 0; n < sweep->study.sweep.case_count && status == FW_OK; ++n) {
        fw_scenario_case_name(sweep, n, name);
        if (table.failures && n < table.row_count && table.failures[n]) continue;
        status = fw_path_join(path, r->wish->directory, name, error);
        if (status == FW_OK) status = write_run(r, name, path, error);
    }
    fw_sweep_table_clear(&table);
    return status;
}

static fw_status write_sweep(report *r, fw_error *error)
{
    fw_scenario *sweep;
    const char *directory = r->wish->directory;
    FW_TRY(fw_sweep_load(&sweep, directory, error));
    fw_json_text(&r->json, "title", sweep->title);
    if (sweep->about) fw_json_text(&r->json, "about", sweep->about);
    const int cases = sweep->study.sweep.case_count;
    r->budget = (size_t)(BUDGET / (cases > 0 ? cases : 1));
    if (r->budget < (size_t)BUDGET_LEAST) r->budget = (size_t)BUDGET_LEAST;
    fw_status status = fw_report_table(&r->json, directory, sweep, error);
    if (status == FW_OK) status = fw_report_pictures(&r->json, directory, sweep, error);
    fw_json_begin(&r->json, "runs", '[');
    if (status == FW_OK) status = write_cases(r, sweep, error);
    fw_json_end(&r->json, ']');
    fw_scenario_destroy(sweep);
    return status;
}

static fw_status write_single(report *r, fw_error *error)
{
    r->budget = (size_t)BUDGET;
    fw_json_begin(&r->json, "runs", '[');
    const fw_status status = write_run(r, NULL, r->wish->directory, error);
    fw_json_end(&r->json, ']');
    return status;
}

/* All facts, to be freed. */
static fw_status collect(report *r, char **text, fw_error *error)
{
    size_t size = 0;
    r->json.out = open_memstream(text, &size);
    if (!r->json.out) return fw_fail_memory(error, "a report");
    fw_json_begin(&r->json, NULL, '{');
    const fw_status status =
        fw_sweep_is_in(r->wish->directory) ? write_sweep(r, error) : write_single(r, error);
    fw_json_end(&r->json, '}');
    if (fclose(r->json.out) == 0) return status;
    return status == FW_OK ? fw_fail_memory(error, "a report") : status;
}

/* JSON within HTML: no text of it can end the element that it stands in. */
static void write_facts(FILE *out, const char *text)
{
    for (; *text; ++text) {
        if (*text == '<')
            fputs("\\u003c", out);
        else
            fputc(*text, out);
    }
}

static void write_page(FILE *out, const char *title, const char *facts)
{
    fputs("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
          "<meta name=\"viewport\" content=\"width=device-width\">\n"
          "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
          "img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'\">\n<title>",
          out);
    fw_xml_write_text(out, title);
    fputs("</title>\n<style>\n", out);
    fputs(fw_report_style, out);
    fputs("</style>\n</head>\n<body>\n"
          "<noscript>This page shows its contents by a script of its own.</noscript>\n"
          "<main id=\"page\"></main>\n<script type=\"application/json\" id=\"facts\">\n",
          out);
    write_facts(out, facts);
    fputs("</script>\n<script>\n", out);
    fputs(fw_report_script, out);
    fputs("</script>\n</body>\n</html>\n", out);
}

static fw_status save(const report *r, const char *facts, fw_error *error)
{
    fw_whole_file *file;
    FW_TRY(fw_whole_file_begin(&file, r->wish->file, error));
    write_page(fw_whole_file_stream(file), r->wish->directory, facts);
    return fw_whole_file_commit(file, error);
}

fw_status fw_report_make(const fw_report_wish *wish, FILE *out, fw_error *error)
{
    report r = {.wish = wish, .kept = 1};
    char *facts = NULL;
    const char *ending = strrchr(wish->file, '.');
    if (!ending || strcmp(ending, ".html") != 0)
        return fw_fail(error, FW_BAD_INPUT, "'%s' as a report, expected a name that ends in .html",
                       wish->file);
    fw_status status = collect(&r, &facts, error);
    if (status == FW_OK) status = save(&r, facts, error);
    free(facts);
    if (status != FW_OK) return status;
    fprintf(out, "report: %s\n", wish->file);
    if (r.kept < 1)
        fprintf(out, "  to keep it small, its player shows %.2g %% of the recorded places\n",
                100 * r.kept);
    return FW_OK;
}
