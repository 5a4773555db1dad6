/* SPDX-License-Identifier: GPL-3.0-or-later */
/* fuzz_checkpoint.c - any bytes as a checkpoint: they are read, or refused with a sentence and then
 * nothing in memory has changed; and what is read can be run on with. The first byte says how they
 * are taken: as the payload of a small state, as a file of it that is sealed anew, so that mutation
 * gets behind the checksum, or as changes in the checkpoint of one of three experiments. Run it
 * without a corpus; see CMakeLists.txt. */
#include "experiments/measures/observer.h"
#include "experiments/results/checkpoint.h"
#include "experiments/storage/sealed_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void demand(int holds)
{
    if (!holds) abort();
}

static void demand_refusal(fw_status status, const fw_error *error)
{
    demand(status == FW_BAD_INPUT && error->status == status);
    demand(error->sentence[0] != '\0' && !strpbrk(error->sentence, "\n\r\t"));
}

/* --- a small state --- */

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
    fw_folder *folder;
    fw_sealed_file *file;
    char name[] = "/dev/shm/fretwork-fuzz-XXXXXX";
    demand(mkdtemp(name) != NULL);
    demand(fw_folder_visit(&folder, name, error) == FW_OK);
    demand(fw_sealed_file_create(&file, folder, "checkpoint-A", FW_CHECKPOINT_KIND, size, error) ==
           FW_OK);
    fw_sealed_file_write(file, data, size);
    demand(fw_sealed_file_commit(file, error) == FW_OK);
    demand(fw_checkpoint_open(&checkpoint, name, "", error) == FW_OK);
    fw_status status = fw_checkpoint_load(checkpoint, sections, 2, NULL, error);
    fw_checkpoint_close(checkpoint);
    demand(fw_folder_remove(folder, "checkpoint-A", error) == FW_OK);
    fw_folder_close(folder);
    rmdir(name);
    return status;
}

static void read_small(const uint8_t *data, size_t size, int as_file)
{
    double x[3] = {1, 2, 3};
    int32_t owner[2] = {0, 1};
    int64_t ticks = 5;
    fw_state_list sheet = {0}, scene = {0};
    fw_state_list_add(&sheet, "x", FW_F64, 3, x);
    fw_state_list_add(&sheet, "owner", FW_I32, 2, owner);
    fw_state_list_add(&scene, "ticks", FW_I64, 1, &ticks);
    const fw_checkpoint_section sections[] = {{"sheet", &sheet}, {"scene", &scene}};
    const uint64_t before = fw_state_list_hash(&sheet) ^ 3 * fw_state_list_hash(&scene);
    fw_error error = {0};
    const fw_status status = as_file ? read_file(data, size, sections, &error)
                                     : read_payload(data, size, sections, &error);
    if (status == FW_OK) return;
    demand_refusal(status, &error);
    demand(before == (fw_state_list_hash(&sheet) ^ 3 * fw_state_list_hash(&scene)));
}

/* --- whole experiments --- */

static const char *const texts[] = {
    "title: a bar is shaken to pieces on a rough floor\n"
    "materials: {glass: {lattice-boltzmann: {rest-mass: 0.6, break-at: 0.6}}}\n"
    "bodies: {bar: {material: glass, shape: {rectangle: [8, 4]}, origin: [0, 0.1],"
    " velocity: [0.1, -0.1]}}\n"
    "walls: {floor: {chain: [[-50, 0], [50, 0]], surface: {coulomb: 0.4}}}\n"
    "forces: {shaking: {body: bar, random: 0.1}}\n"
    "run: {steps: 1000}\n",
    "title: two small crystals rest\n"
    "materials: {crystal: {movable-particles: {return-force: {amplitude: 1, axes: lab}}}}\n"
    "bodies:\n"
    "  left: {material: crystal, lattice: hexagonal, shape: {rectangle: [5, 4]}, origin: [-5, 0]}\n"
    "  right: {material: crystal, lattice: hexagonal, shape: {rectangle: [5, 4]},"
    " origin: [0.5, 0]}\n"
    "dynamics: {temperature: 0.001}\n"
    "run: {steps: 1000}\n"
    "profile: {every: 2, far: [2, 4], contact: 1.5}\n",
    "title: an automaton tears\n"
    "materials: {m: {elastic-automaton: {c1: 0.9, c2: 0.5, break-at: 0.1}}}\n"
    "bodies: {b: {material: m, shape: {rectangle: [6, 6]}, origin: [0, 0.2],"
    " velocity: [0, -0.05]}}\n"
    "walls: {floor: {chain: [[-50, 0], [50, 0]]}}\n"
    "run: {steps: 1000}\n",
};
enum { EXPERIMENTS = sizeof texts / sizeof texts[0], SECTIONS = 8 };

typedef struct subject {
    fw_scenario *scenario;
    fw_observer *observer;
    fw_checkpoint_section sections[SECTIONS];
    fw_state_list states[SECTIONS];
    int section_count;
    unsigned char *payload, *changed;
    uint64_t size;
} subject;

/* Some steps on, and its checkpoint. */
static void make_subject(subject *s, const char *text)
{
    fw_error error = {0};
    char name[] = "/dev/shm/fretwork-fuzz-XXXXXX";
    fw_checkpoint *checkpoint;
    fw_folder *folder;
    if (fw_scenario_read(&s->scenario, "s.yaml", text, strlen(text), NULL, 0, &error) != FW_OK ||
        fw_observer_create(&s->observer, s->scenario, &error) != FW_OK) {
        fprintf(stderr, "%s\n", error.sentence);
        abort();
    }
    for (int step = 0; step < 7; ++step)
        demand(fw_observer_advance(s->observer, 1, &error) == FW_OK);
    fw_scene *scene = s->observer->experiment->scene;
    for (int n = 0; n < fw_scene_section_count(scene); ++n) {
        s->sections[n].name = fw_scene_section(scene, n, &s->states[n]);
        s->sections[n].state = &s->states[n];
        s->section_count += 1;
    }
    if (s->observer->profile) {
        fw_profile_state(s->observer->profile, &s->states[s->section_count]);
        s->sections[s->section_count] =
            (fw_checkpoint_section){"profile", &s->states[s->section_count]};
        s->section_count += 1;
    }
    demand(s->section_count <= SECTIONS && mkdtemp(name) != NULL);
    demand(fw_checkpoint_open(&checkpoint, name, "", &error) == FW_OK);
    demand(fw_checkpoint_write(checkpoint, s->sections, s->section_count, 7, &error) == FW_OK);
    fw_checkpoint_close(checkpoint);
    demand(fw_folder_visit(&folder, name, &error) == FW_OK);
    demand(fw_sealed_file_read(folder, "checkpoint-A", FW_CHECKPOINT_KIND, &s->payload, &s->size,
                               &error) == FW_OK);
    demand(fw_folder_remove(folder, "checkpoint-A", &error) == FW_OK);
    fw_folder_close(folder);
    rmdir(name);
    s->changed = malloc(s->size);
    demand(s->changed != NULL);
}

/* Five bytes each: a place, and what is written there. */
static void run_changed(subject *s, const uint8_t *data, size_t size)
{
    int64_t step;
    fw_error error = {0};
    memcpy(s->changed, s->payload, s->size);
    for (; size >= 5; data += 5, size -= 5) {
        uint32_t place;
        memcpy(&place, data, sizeof place);
        s->changed[place % s->size] = data[4];
    }
    fw_status status = fw_checkpoint_decode(s->changed, s->size, fw_checkpoint_hash(""),
                                            s->sections, s->section_count, &step, &error);
    if (status == FW_OK) status = fw_scene_restored(s->observer->experiment->scene, &error);
    if (status == FW_OK && s->observer->profile)
        status = fw_profile_restored(s->observer->profile, &error);
    if (status != FW_OK) {
        demand_refusal(status, &error);
        return;
    }
    for (int n = 0; n < 3 && status == FW_OK; ++n)
        status = fw_observer_advance(s->observer, 1, &error);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static subject subjects[EXPERIMENTS];
    if (!subjects[0].scenario)
        for (int n = 0; n < EXPERIMENTS; ++n) make_subject(&subjects[n], texts[n]);
    if (size == 0) return 0;
    const int way = data[0] % 16;
    if (way < 2)
        read_small(data + 1, size - 1, way == 0);
    else
        run_changed(&subjects[way % EXPERIMENTS], data + 1, size - 1);
    return 0;
}
