/* SPDX-License-Identifier: GPL-3.0-or-later */
/* document_parts.h - how a document is put together; for document_reader.c, which reads it, alone.
 */
#ifndef FW_DOCUMENT_PARTS_H
#define FW_DOCUMENT_PARTS_H

#include "experiments/text/document.h"

/* A document without a tree; `file` as for fw_document_parse. On failure, FW_SYSTEM_FAILED,
 * *document is NULL. */
fw_status fw_document_create(fw_document **document, const char *file, fw_error *error);
/* The tree, whose memory is the document's. */
void fw_document_set_root(fw_document *document, fw_node *root);
/* Keeps a copy of the --set option, which sentences will name. What it wrote has *number, counted
 * from 1, in its fw_place as `setting`. FW_SYSTEM_FAILED without memory. */
fw_status fw_document_add_option(fw_document *document, const char *text, int *number,
                                 fw_error *error);

#endif
