/* SPDX-License-Identifier: GPL-3.0-or-later */
/* settings.h - `--set KEY=VALUE`: changes to a scenario on the command line.
 *
 * KEY is the path of a value, such as bodies.sheet.velocity or expect.0.within (items of a list
 * count from 0); VALUE is YAML. The value replaces the one that is there or is added: keys, a
 * new name (`walls.floor={box: [0, 0, 9, 9]}`), or the item after the last of a list. Of several
 * alternatives (a shape is a rectangle or a disc) the new one takes the place of the old. */
#ifndef FW_SETTINGS_H
#define FW_SETTINGS_H

#include "experiments/schema/schema.h"

/* Applies the options in order to a document whose keys are those of `root`. FW_BAD_INPUT with
 * "--set OPTION: sentence" for a key that the schema does not know, a name that is not there, or a
 * value that is not YAML; whether the value is right is for fw_schema_check to say, which names the
 * option too. */
fw_status fw_settings_apply(fw_document *document, const fw_section *root,
                            const char *const *settings, int count, fw_error *error);

#endif
