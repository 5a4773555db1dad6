/* SPDX-License-Identifier: GPL-3.0-or-later */
/* document_reader.h - from text to a tree; for document.c alone. */
#ifndef FW_DOCUMENT_READER_H
#define FW_DOCUMENT_READER_H

#include "experiments/text/document.h"

/* Reads `text` as one tree with memory of the document. `setting` > 0: it was written in that
 * --set option. */
fw_status fw_document_read(fw_document *document, int setting, const char *text, size_t length,
                           fw_node **root, fw_error *error);

#endif
