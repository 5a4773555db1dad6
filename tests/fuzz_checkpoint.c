/* SPDX-License-Identifier: GPL-3.0-or-later */
/* fuzz_checkpoint.c - any bytes as a checkpoint. The first byte says how they are taken: as a file,
 * or as a payload whose checksum and scenario were right, which mutation would never find. Run it
 * without a corpus; see CMakeLists.txt. */
#include "experiments/checkpoint.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void read_payload(const uint8_t *data, size_t size, const fw_checkpoint_section *sections)
{
    int64_t step;
    uint64_t scenario = 0;
    fw_error error;
    if (size >= 24) memcpy(&scenario, data + 16, sizeof scenario);
    fw_checkpoint_decode(data, size, scenario, sections, 2, &step, &error);
}

static void read_file(const uint8_t *data, size_t size, const fw_checkpoint_section *sections)
{
    fw_error error;
    fw_checkpoint *checkpoint;
    char folder[] = "/dev/shm/fretwork-fuzz-XXXXXX", path[64];
    if (!mkdtemp(folder)) abort();
    snprintf(path, sizeof path, "%s/checkpoint-A", folder);
    FILE *file = fopen(path, "wb");
    if (!file || fwrite(data, 1, size, file) != size || fclose(file) != 0) abort();
    if (fw_checkpoint_open(&checkpoint, folder, "", &error) != FW_OK) abort();
    fw_checkpoint_load(checkpoint, sections, 2, NULL, &error);
    fw_checkpoint_close(checkpoint);
    unlink(path);
    rmdir(folder);
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
    if (data[0] % 16 == 0)
        read_file(data + 1, size - 1, sections);
    else
        read_payload(data + 1, size - 1, sections);
    return 0;
}
