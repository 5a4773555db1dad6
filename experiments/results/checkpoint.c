/* SPDX-License-Identifier: GPL-3.0-or-later */
/* checkpoint.c - saving and bringing back state lists.
 * State: which of the two files is to be written next, and the sequence number of the last one.
 * Invariant: the file written next is never the newest whole one. Payload of a file:
 *     sequence | step | scenario hash | sections
 *     section: name | number of arrays | arrays
 *     array: name | element type | count | data
 * where names are a length and letters. Start reading at walk(). */
#include "experiments/results/checkpoint.h"

#include "experiments/storage/checksum.h"
#include "experiments/storage/sealed_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SLOTS = 2 };
static const char *const slot_names[SLOTS] = {"checkpoint-A", "checkpoint-B"};

struct fw_checkpoint {
    fw_folder *folder;
    uint64_t scenario, sequence;
    int next;
};

uint64_t fw_checkpoint_hash(const char *scenario)
{
    return fw_checksum_add(FW_CHECKSUM_OF_NOTHING, scenario, strlen(scenario));
}

/* ---- writing ---- */

static uint64_t name_size(const char *name)
{
    return sizeof(uint32_t) + strlen(name);
}

uint64_t fw_checkpoint_size(const fw_checkpoint_section *sections, int count)
{
    uint64_t size = 3 * sizeof(uint64_t) + sizeof(uint32_t);
    for (int s = 0; s < count; ++s) {
        size += name_size(sections[s].name) + sizeof(uint32_t);
        for (int a = 0; a < sections[s].state->count; ++a) {
            const fw_array *array = &sections[s].state->array[a];
            size += name_size(array->name) + sizeof(uint32_t) + sizeof(uint64_t) +
                    array->count * fw_element_size(array->element);
        }
    }
    return size;
}

static void put_small(fw_sealed_file *file, int number)
{
    uint32_t value = (uint32_t)number;
    fw_sealed_file_write(file, &value, sizeof value);
}

static void put_large(fw_sealed_file *file, uint64_t value)
{
    fw_sealed_file_write(file, &value, sizeof value);
}

static void put_name(fw_sealed_file *file, const char *name)
{
    put_small(file, (int)strlen(name));
    fw_sealed_file_write(file, name, strlen(name));
}

fw_status fw_checkpoint_write(fw_checkpoint *checkpoint, const fw_checkpoint_section *sections,
                              int count, int64_t step, fw_error *error)
{
    fw_sealed_file *file;
    FW_TRY(fw_sealed_file_create(&file, checkpoint->folder, slot_names[checkpoint->next],
                                 FW_CHECKPOINT_KIND, fw_checkpoint_size(sections, count), error));
    put_large(file, checkpoint->sequence + 1);
    put_large(file, (uint64_t)step);
    put_large(file, checkpoint->scenario);
    put_small(file, count);
    for (int s = 0; s < count; ++s) {
        put_name(file, sections[s].name);
        put_small(file, sections[s].state->count);
        for (int a = 0; a < sections[s].state->count; ++a) {
            const fw_array *array = &sections[s].state->array[a];
            put_name(file, array->name);
            put_small(file, (int)array->element);
            put_large(file, array->count);
            fw_sealed_file_write(file, array->data, array->count * fw_element_size(array->element));
        }
    }
    FW_TRY(fw_sealed_file_commit(file, error));
    checkpoint->sequence += 1;
    checkpoint->next = (checkpoint->next + 1) % SLOTS;
    return FW_OK;
}

/* ---- reading ---- */

/* Bytes not read yet. Every length is compared with `left` before it is used. */
typedef struct cursor {
    const unsigned char *at;
    uint64_t left;
} cursor;

static const unsigned char *take(cursor *from, uint64_t count)
{
    if (count > from->left) return NULL;
    const unsigned char *taken = from->at;
    from->at += count;
    from->left -= count;
    return taken;
}

static bool take_small(cursor *from, uint32_t *value)
{
    const unsigned char *bytes = take(from, sizeof *value);
    if (bytes) memcpy(value, bytes, sizeof *value);
    return bytes != NULL;
}

static bool take_large(cursor *from, uint64_t *value)
{
    const unsigned char *bytes = take(from, sizeof *value);
    if (bytes) memcpy(value, bytes, sizeof *value);
    return bytes != NULL;
}

static fw_status fail_short(fw_error *error)
{
    return fw_fail(error, FW_BAD_INPUT, "the checkpoint ends in the middle of its arrays");
}

/* A name that must be `wanted`; `what` says of what. */
static fw_status expect_name(cursor *from, const char *what, const char *wanted, fw_error *error)
{
    uint32_t length;
    const unsigned char *letters = NULL;
    if (take_small(from, &length)) letters = take(from, length);
    if (!letters) return fail_short(error);
    if (length == strlen(wanted) && memcmp(letters, wanted, length) == 0) return FW_OK;
    /* Whatever the bytes are, the sentence is printable. */
    char found[64] = "";
    for (uint32_t i = 0; i < length && i < sizeof found - 1; ++i)
        found[i] = letters[i] >= ' ' && letters[i] < 127 ? (char)letters[i] : '?';
    return fw_fail(error, FW_BAD_INPUT, "the checkpoint has the %s '%s' where '%s' is expected",
                   what, found, wanted);
}

static fw_status expect_count(cursor *from, const char *what, const char *of, int wanted,
                              fw_error *error)
{
    uint32_t found;
    if (!take_small(from, &found)) return fail_short(error);
    if (found == (uint32_t)wanted) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT, "the checkpoint has %lu %s of %s, expected are %d",
                   (unsigned long)found, what, of, wanted);
}

static fw_status walk_array(cursor *from, const char *section, const fw_array *array, bool apply,
                            fw_error *error)
{
    uint32_t element;
    uint64_t count;
    FW_TRY(expect_name(from, "array", array->name, error));
    if (!take_small(from, &element) || !take_large(from, &count)) return fail_short(error);
    if (element != (uint32_t)array->element || count != array->count)
        return fw_fail(error, FW_BAD_INPUT,
                       "the checkpoint has %llu elements of type %lu in '%s' of '%s', expected are "
                       "%llu of type %d",
                       (unsigned long long)count, (unsigned long)element, array->name, section,
                       (unsigned long long)array->count, (int)array->element);
    /* The count is the one of an array in memory now: the product cannot overflow. */
    uint64_t bytes = count * fw_element_size(array->element);
    const unsigned char *data = take(from, bytes);
    if (!data) return fail_short(error);
    if (apply && bytes > 0) memcpy(array->data, data, bytes);
    return FW_OK;
}

/* Goes through the whole payload once, comparing it with the state lists or copying it there. */
static fw_status walk(cursor from, uint64_t scenario, const fw_checkpoint_section *sections,
                      int count, bool apply, int64_t *step, fw_error *error)
{
    uint64_t sequence, steps, hash;
    if (!take_large(&from, &sequence) || !take_large(&from, &steps) || !take_large(&from, &hash))
        return fail_short(error);
    if (hash != scenario)
        return fw_fail(error, FW_BAD_INPUT, "the checkpoint belongs to another scenario");
    FW_TRY(expect_count(&from, "sections", "the run", count, error));
    for (int s = 0; s < count; ++s) {
        const fw_state_list *state = sections[s].state;
        FW_TRY(expect_name(&from, "section", sections[s].name, error));
        FW_TRY(expect_count(&from, "arrays", sections[s].name, state->count, error));
        for (int a = 0; a < state->count; ++a)
            FW_TRY(walk_array(&from, sections[s].name, &state->array[a], apply, error));
    }
    if (from.left != 0)
        return fw_fail(error, FW_BAD_INPUT, "the checkpoint goes on for %llu bytes after its end",
                       (unsigned long long)from.left);
    *step = (int64_t)steps;
    return FW_OK;
}

fw_status fw_checkpoint_decode(const unsigned char *payload, uint64_t size, uint64_t scenario,
                               const fw_checkpoint_section *sections, int count, int64_t *step,
                               fw_error *error)
{
    cursor all = {payload, size};
    FW_TRY(walk(all, scenario, sections, count, false, step, error));
    return walk(all, scenario, sections, count, true, step, error);
}

/* ---- the two files ---- */

/* The sequence number at the start of a payload; 0, which no checkpoint has, when it has none. */
static uint64_t sequence_of(const unsigned char *payload, uint64_t size)
{
    uint64_t sequence = 0;
    cursor from = {payload, size};
    return take_large(&from, &sequence) ? sequence : 0;
}

typedef struct slot {
    bool present;
    unsigned char *payload; /* NULL: missing or not whole */
    uint64_t size, sequence;
    fw_error error;
} slot;

static void read_slots(const fw_checkpoint *checkpoint, slot slots[SLOTS])
{
    for (int i = 0; i < SLOTS; ++i) {
        slots[i] = (slot){.present = fw_folder_has(checkpoint->folder, slot_names[i])};
        if (!slots[i].present) continue;
        if (fw_sealed_file_read(checkpoint->folder, slot_names[i], FW_CHECKPOINT_KIND,
                                &slots[i].payload, &slots[i].size, &slots[i].error) == FW_OK)
            slots[i].sequence = sequence_of(slots[i].payload, slots[i].size);
    }
}

static void free_slots(slot slots[SLOTS])
{
    for (int i = 0; i < SLOTS; ++i) free(slots[i].payload);
}

/* The whole slot with the highest sequence number; -1 when none is whole. */
static int newest(const slot slots[SLOTS])
{
    int found = -1;
    for (int i = 0; i < SLOTS; ++i)
        if (slots[i].payload && (found < 0 || slots[i].sequence > slots[found].sequence)) found = i;
    return found;
}

/* From now on the other file than `current` is written first. */
static void follow(fw_checkpoint *checkpoint, const slot slots[SLOTS], int current)
{
    if (current < 0) return;
    checkpoint->sequence = slots[current].sequence;
    checkpoint->next = (current + 1) % SLOTS;
}

fw_status fw_checkpoint_open(fw_checkpoint **checkpoint, const char *directory,
                             const char *scenario, fw_error *error)
{
    slot slots[SLOTS];
    fw_checkpoint *opened = calloc(1, sizeof *opened);
    *checkpoint = NULL;
    if (!opened) return fw_fail_memory(error, "checkpoints");
    opened->scenario = fw_checkpoint_hash(scenario);
    fw_status status = fw_folder_visit(&opened->folder, directory, error);
    if (status != FW_OK) {
        free(opened);
        return status;
    }
    read_slots(opened, slots);
    follow(opened, slots, newest(slots));
    free_slots(slots);
    *checkpoint = opened;
    return FW_OK;
}

void fw_checkpoint_close(fw_checkpoint *checkpoint)
{
    if (!checkpoint) return;
    fw_folder_close(checkpoint->folder);
    free(checkpoint);
}

bool fw_checkpoint_exists(const fw_checkpoint *checkpoint)
{
    for (int i = 0; i < SLOTS; ++i)
        if (fw_folder_has(checkpoint->folder, slot_names[i])) return true;
    return false;
}

fw_status fw_checkpoint_load(fw_checkpoint *checkpoint, const fw_checkpoint_section *sections,
                             int count, fw_checkpoint_origin *origin, fw_error *error)
{
    slot slots[SLOTS];
    fw_checkpoint_origin from = {0};
    fw_status status;
    read_slots(checkpoint, slots);
    int chosen = newest(slots);
    if (chosen < 0) {
        int broken = slots[0].present ? 0 : 1;
        if (slots[broken].present) {
            status = slots[broken].error.status;
            if (error) *error = slots[broken].error;
            if (error && slots[1 - broken].present)
                fw_fail_within(error, "none of two checkpoints can be used");
        } else {
            status = fw_fail(error, FW_BAD_INPUT, "there is no checkpoint");
        }
        free_slots(slots);
        return status;
    }
    const slot *other = &slots[1 - chosen];
    status = fw_checkpoint_decode(slots[chosen].payload, slots[chosen].size, checkpoint->scenario,
                                  sections, count, &from.step, error);
    if (status == FW_OK) {
        snprintf(from.name, sizeof from.name, "%s", slot_names[chosen]);
        from.fallen_back = other->present && !other->payload;
        from.newer_error = other->error;
        follow(checkpoint, slots, chosen);
        if (origin) *origin = from;
    } else if (error) {
        char path[FW_PATH_SIZE];
        fw_error ignored;
        if (fw_folder_path(checkpoint->folder, slot_names[chosen], path, &ignored) == FW_OK)
            fw_fail_within(error, "%s", path);
    }
    free_slots(slots);
    return status;
}
