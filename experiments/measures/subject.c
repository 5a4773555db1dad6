/* SPDX-License-Identifier: GPL-3.0-or-later */
/* subject.c - bodies, walls, grips and analyses as what is measured. Keeps no state. Start reading
 * at fw_subject_at(). */
#include "experiments/measures/subject.h"

#include "core/particles/particles.h"

#include "experiments/text/spelling.h"

#include <stdio.h>
#include <string.h>

fw_subject fw_subject_none(const fw_observer *observer)
{
    return (fw_subject){.body = -1, .wall = -1, .grip = -1, .particle = -1, .observer = observer};
}

bool fw_subject_equals(fw_subject one, fw_subject other)
{
    return one.body == other.body && one.wall == other.wall && one.grip == other.grip &&
           one.particle == other.particle && one.analysis == other.analysis;
}

int fw_subject_count(const fw_observer *observer, const fw_quantity *quantity)
{
    const fw_experiment *experiment = observer->experiment;
    switch (quantity->scope) {
    case FW_SCOPE_SCENE:
        return 1;
    case FW_SCOPE_BODIES:
        return 1 + experiment->body_count;
    case FW_SCOPE_BODY:
        return experiment->body_count;
    case FW_SCOPE_WALL:
    case FW_SCOPE_PISTON:
        return fw_scene_wall_count(experiment->scene);
    case FW_SCOPE_GRIP:
        return fw_scene_grip_count(experiment->scene);
    case FW_SCOPE_ANALYSIS:
        return observer->analysis_count;
    case FW_SCOPE_SITE:
    case FW_SCOPE_STUDY:
        break;
    }
    return 0;
}

static bool is_body(const fw_observer *observer, const fw_quantity *quantity, int body,
                    fw_subject *subject)
{
    subject->body = body;
    return fw_quantity_fits(quantity, fw_experiment_solid(observer->experiment, body)->model->name);
}

bool fw_subject_at(const fw_observer *observer, const fw_quantity *quantity, int n,
                   fw_subject *subject)
{
    *subject = fw_subject_none(observer);
    switch (quantity->scope) {
    case FW_SCOPE_SCENE:
        return true;
    case FW_SCOPE_BODIES:
        return n == 0 || is_body(observer, quantity, n - 1, subject);
    case FW_SCOPE_BODY:
        return is_body(observer, quantity, n, subject);
    case FW_SCOPE_WALL:
        subject->wall = n;
        return true;
    case FW_SCOPE_PISTON:
        subject->wall = n;
        return observer->experiment->scenario->walls[n].is_piston;
    case FW_SCOPE_GRIP:
        subject->grip = n;
        return true;
    case FW_SCOPE_ANALYSIS:
        subject->analysis = observer->analyses[n];
        return fw_quantity_fits(quantity, fw_analysis_kind_name(subject->analysis->what->kind));
    case FW_SCOPE_SITE:
    case FW_SCOPE_STUDY:
        break;
    }
    return false;
}

void fw_subject_name(const fw_observer *observer, fw_subject s, char name[FW_SUBJECT_NAME])
{
    const fw_experiment *e = observer->experiment;
    const size_t room = FW_SUBJECT_NAME;
    name[0] = '\0';
    if (s.particle >= 0) {
        const fw_site site = e->bodies[s.body].sites.site[s.particle];
        snprintf(name, room, "%s[%d,%d]", e->bodies[s.body].name, site.i, site.j);
    } else if (s.body >= 0) {
        snprintf(name, room, "%s", e->bodies[s.body].name);
    } else if (s.analysis) {
        snprintf(name, room, "%s", s.analysis->what->name);
    } else if (s.wall >= 0) {
        snprintf(name, room, "%s", fw_wall_name(fw_scene_wall(e->scene, s.wall)));
    } else if (s.grip >= 0) {
        snprintf(name, room, "%s", fw_grip_name(fw_scene_observe_grip(e->scene, s.grip)));
    }
}

bool fw_subject_exists(const fw_observer *observer, const fw_quantity *quantity)
{
    const fw_solid *particles = fw_experiment_particles(observer->experiment);
    switch (quantity->needs) {
    case FW_NEEDS_NOTHING:
    case FW_NEEDS_NO_POSITIONS:
        return true;
    case FW_NEEDS_TWO_GRIPS:
        return fw_scene_grip_count(observer->experiment->scene) >= 2;
    case FW_NEEDS_TWO_CRYSTALS:
        return particles && fw_particles_group_count(particles) > 1;
    case FW_NEEDS_PROFILE:
        return observer->profile != NULL;
    }
    return false;
}

/* --- names --- */

fw_status fw_subject_find_quantity(const fw_observer *observer, fw_schema_name name,
                                   const fw_quantity **quantity, fw_error *error)
{
    const fw_scenario *scenario = observer->experiment->scenario;
    char word[FW_NAME_BYTES + 1];
    snprintf(word, sizeof word, "%.*s", (int)strcspn(name.text, "."), name.text);
    *quantity = fw_quantity_find(word);
    if (*quantity) return FW_OK;
    for (const fw_renamed_quantity *renamed = fw_renamed_quantities; renamed->name; ++renamed)
        if (strcmp(renamed->old_name, word) == 0)
            return fw_scenario_fail(scenario, name.place, error,
                                    "quantity %s is not known; it is now called %s", word,
                                    renamed->name);
    fw_suggestion suggestion = fw_suggestion_begin(word);
    for (const fw_quantity *q = fw_quantity_first(); q; q = fw_quantity_next(q))
        fw_suggestion_offer(&suggestion, q->name);
    if (suggestion.best)
        return fw_scenario_fail(scenario, name.place, error,
                                "quantity %s is not known; did you mean %s?", word,
                                suggestion.best);
    return fw_scenario_fail(scenario, name.place, error,
                            "quantity %s is not known, expected one of `fretwork quantities`",
                            word);
}

static bool is_named(const fw_observer *observer, const fw_quantity *quantity, const char *word,
                     size_t length, fw_subject *subject)
{
    char name[FW_SUBJECT_NAME];
    const int count = fw_subject_count(observer, quantity);
    for (int n = 0; n < count && length > 0; ++n) {
        if (!fw_subject_at(observer, quantity, n, subject)) continue;
        fw_subject_name(observer, *subject, name);
        if (strlen(name) == length && memcmp(name, word, length) == 0) return true;
    }
    return false;
}

static const char *kind_of(const fw_quantity *quantity)
{
    switch (quantity->scope) {
    case FW_SCOPE_BODIES:
    case FW_SCOPE_BODY:
        return " with the name of a body";
    case FW_SCOPE_SITE:
        return " in `expect`, with body and site,";
    case FW_SCOPE_WALL:
        return " with the name of a wall";
    case FW_SCOPE_PISTON:
        return " with the name of a piston";
    case FW_SCOPE_GRIP:
        return " with the name of a grip";
    case FW_SCOPE_ANALYSIS:
        return " with the name of an analysis of its kind";
    case FW_SCOPE_SCENE:
    case FW_SCOPE_STUDY:
        break;
    }
    return " alone";
}

fw_status fw_subject_find(const fw_observer *observer, const fw_quantity *quantity,
                          fw_schema_name name, bool *named, fw_subject *subject, fw_error *error)
{
    const char *dot = strchr(name.text, '.');
    *named = false;
    *subject = fw_subject_none(observer);
    if (!dot || fw_quantity_find_component(quantity, dot + 1) >= 0) return FW_OK;
    const char *rest = dot + 1, *last = strrchr(rest, '.');
    *named = is_named(observer, quantity, rest, strlen(rest), subject) ||
             (last && fw_quantity_find_component(quantity, last + 1) >= 0 &&
              is_named(observer, quantity, rest, (size_t)(last - rest), subject));
    if (*named) return FW_OK;
    return fw_scenario_fail(observer->experiment->scenario, name.place, error,
                            "%s is not measured of %s, expected %s%s%s%s", quantity->name, rest,
                            quantity->name, kind_of(quantity),
                            quantity->components[0] ? " or with one of the components " : "",
                            quantity->components);
}
