/* SPDX-License-Identifier: GPL-3.0-or-later */
/* start_picture.h - a picture of an experiment that has not run. */
#ifndef FW_START_PICTURE_H
#define FW_START_PICTURE_H

#include "experiments/setup/experiment.h"

/* Into a file that ends in .png, .svg or .pdf. */
fw_status fw_start_picture_draw(const fw_experiment *experiment, const char *file, fw_error *error);

#endif
