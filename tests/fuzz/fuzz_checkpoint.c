/* SPDX-License-Identifier: GPL-3.0-or-later */
/* fuzz_checkpoint.c - any bytes as a checkpoint: they are read, or refused with a sentence and then
 * nothing in memory has changed. The first byte says how they are taken: as a file, or as a payload
 * whose checksum and scenario were right, which mutation would never find. Run it without a corpus;
 * see CMakeLists.txt. */
#include "experiments/results/checkpoint.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void demand(int holds)
{
    if (!holds) abort();
}

static fw_status read_payload(const uint8_t *data, size_t size,
                              const fw_checkpoint_section *sections, fw_error *error)
{
    int64_t step;
    uint64_t scenario = 0;
    if (size >= 24) memcpy(&scenario, data + 16, sizeof scenario);
    return fw_checkpoint_decode(data, size, scenario, sections, 2, &step, error);
}

static fw_status read_file(const uint8_t *data, size_t size, const fw_checkpoint_section *sections,
                           fw_error *error)
{
    fw_checkpoint *checkpoint;
    char folder[] = "/dev/shm/fretwork-fuzz-XXXXXX", path[64];
    demand(mkdtemp(folder) != NULL);
    snprintf(path, sizeof path, "%s/checkpoint-A", folder);
    FILE *file = fopen(path, "wb");
    demand(file && fwrite(data, 1, size, file) == size && fclose(file) == 0);
    demand(fw_checkpoint_open(&checkpoint, folder, "", error) == FW_OK);
    fw_status status = fw_checkpoint_load(checkpoint, sections, 2, NULL, error);
    fw_checkpoint_close(checkpoint);
    unlink(path);
    rmdir(folder);
    return status;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    double x[3] = {1, 2, 3};
    int32_t owner[2] = {0, 1};
    int64_t ticks = 5;
    fw_state_list sheet = {0}, scene = {0};
    fw_state_list_add(&sheet, "x", FW_F64, 3, x);
    fw_state_list_add(&sheet, "owner", FW_I32, 2, owner);
    fw_state_list_add(&scene, "ticks", FW_I64, 1, &ticks);
    const fw_checkpoint_section sections[] = {{"sheet", &sheet}, {"scene", &scene}};
    if (size == 0) return 0;
    const uint64_t before = fw_state_list_hash(&sheet) ^ 3 * fw_state_list_hash(&scene);
    fw_error error = {0};
    fw_status status = data[0] % 16 == 0 ? read_file(data + 1, size - 1, sections, &error)
                                         : read_payload(data + 1, size - 1, sections, &error);
    if (status == FW_OK) return 0;
    demand(status == FW_BAD_INPUT && error.status == status);
    demand(error.sentence[0] != '\0' && !strpbrk(error.sentence, "\n\r\t"));
    demand(before == (fw_state_list_hash(&sheet) ^ 3 * fw_state_list_hash(&scene)));
    return 0;
}
