/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_choice.h - what exactly a picture shows: kind, frames, field, observables, file. */
#ifndef FW_PLOT_CHOICE_H
#define FW_PLOT_CHOICE_H

#include "experiments/pictures/plot.h"
#include "plot_parts.h"

/* A picture, and the texts and lists that it points into. */
typedef struct fw_plot_choice {
    fw_plot_picture picture;
    fw_plot_names names;
    const char *name;        /* of the file, without folder and ending */
    char file[FW_PATH_SIZE]; /* in the folder of the result; unused where the wish names one */
    char data[FW_NAME_BYTES + 16];
    char caption[1024];
    char notes[640]; /* what the output has to say of steps that were not recorded */
} fw_plot_choice;

/* The wish's own words come first, then those of the scenario's picture, then what is usual.
 * FW_BAD_INPUT: the result does not hold it. Cleared also after a failure. */
fw_status fw_plot_choose(fw_plot_choice *choice, const fw_plot_result *result,
                         const fw_plot_wish *wish, fw_error *error);
/* FW_BAD_INPUT where the wish names what pictures of this kind do not draw: it is refused, not
 * passed over. */
fw_status fw_plot_check_wish(const fw_plot_wish *wish, fw_picture_kind kind, fw_error *error);
/* A page of the width that the wish wants. */
fw_page fw_plot_page(const fw_plot_wish *wish);
void fw_plot_choice_clear(fw_plot_choice *choice);

/* The field that is shown where none is named: the first that was recorded; those of what a contact
 * does are passed over. NULL: there is none. */
const char *fw_plot_usual_field(const fw_plot_result *result);

/* Is it drawn from one run, not from all cases of a sweep? */
bool fw_plot_is_of_case(const fw_scenario_picture *picture);

#endif
