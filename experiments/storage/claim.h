/* SPDX-License-Identifier: GPL-3.0-or-later */
/* claim.h - work in a folder that several processes, perhaps on several machines, may do: whoever
 * claims it does it. The claim is a lock of the system on a file in the folder: it ends with the
 * process, however that ends, and is not in the way of those who hold the folder (folder.h). */
#ifndef FW_CLAIM_H
#define FW_CLAIM_H

#include "core/status.h"

#define FW_CLAIM_FILE "taken"
/* What the file begins with, before the machine and the number of the process. */
#define FW_CLAIM_KIND "taken by "

typedef struct fw_claim fw_claim;

/* Makes the folder where it is missing. FW_OK and *claim NULL: somebody else claims it, or holds
 * the folder. FW_SYSTEM_FAILED where the folder or the file cannot be made. */
fw_status fw_claim_take(fw_claim **claim, const char *directory, fw_error *error);
/* Removes the file of a claim whose holder was killed, where nobody has it now. */
void fw_claim_tidy(const char *directory);
/* Its file goes, and the folder with it where nothing else is in it. NULL is legal. */
void fw_claim_release(fw_claim *claim);

#endif
