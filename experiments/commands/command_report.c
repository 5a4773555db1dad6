/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_report.c - a result as one page that stands by itself. Keeps no state. */
#include "citation.h"

#include "experiments/commands/command.h"
#include "experiments/pictures/report_page.h"

fw_status fw_command_report(const fw_arguments *arguments, fw_error *error)
{
    if (!arguments->output)
        return fw_fail(error, FW_BAD_INPUT,
                       "report needs a file, expected -o and a name that ends in .html");
    const fw_report_wish wish = {
        .directory = arguments->words[0], .file = arguments->output, .cite = fw_citation_print};
    return fw_report_make(&wish, stdout, error);
}
