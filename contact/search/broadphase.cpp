// SPDX-License-Identifier: GPL-3.0-or-later
// broadphase.cpp - walls in a Box2D world, and the question what is near a box; at the end the same
// for boxes that move (box_tree.h).
// State: one body per wall at `centre`, one fixture per facet, grown by `margin`.
// Invariant: a fixture's box in the tree covers its facet wherever the wall is within `margin`
// (per component) of `centre`, all rounding included. Start reading at fw_broadphase_query().

// C's compound literals in inline functions, which every compiler of ours accepts in C++, too.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"
#include "contact/search/broadphase.h"
#include "box_tree.h"
#pragma GCC diagnostic pop

#include <algorithm>
#include <box2d/box2d.h>
#include <cassert>
#include <cfloat>
#include <cmath>
#include <memory>
#include <new>
#include <vector>

namespace
{

// How many Box2D units the walls span, at most: single walls are then of the size Box2D is made
// for.
constexpr double span_of_scene = 64;
// A wall that moves is given room for so many steps like the present one,
constexpr double steps_ahead = 16;
// and at least this much, in Box2D units; its tree adds 0.1 to every box anyway.
constexpr double least_margin = 0.0625;

struct placed_wall {
    const fw_wall *wall;
    b2Body *body;
    fw_vec2 centre; // displacement for which the body stands
    double margin;
    double sweep; // length, in this step
};

float clamped_to_float(double value)
{
    // Far beyond all walls, and still small enough that sums of a few cannot overflow.
    constexpr double limit = 1e30;
    if (!(value > -limit)) return static_cast<float>(-limit);
    return static_cast<float>(std::min(value, limit));
}

float rounded_up(double value)
{
    return std::nextafterf(clamped_to_float(value), FLT_MAX);
}

float rounded_down(double value)
{
    return std::nextafterf(clamped_to_float(value), -FLT_MAX);
}

double magnitude(fw_vec2 v)
{
    return std::max(std::fabs(v.x), std::fabs(v.y));
}

} // namespace

struct fw_broadphase {
    fw_vec2 origin;
    double scale; // Box2D units per length, a power of two
    b2World world{b2Vec2_zero};
    std::vector<placed_wall> walls;
    std::vector<const fw_facet *> facets;
    long generation = 0;

    fw_vec2 scaled(fw_vec2 point) const
    {
        return fw_vec2_scale(scale, fw_vec2_subtract(point, origin));
    }
};

namespace
{

b2Vec2 to_b2(fw_vec2 v)
{
    return b2Vec2(clamped_to_float(v.x), clamped_to_float(v.y));
}

// How far the wall may be from its definition.
double away(const placed_wall &place)
{
    return magnitude(place.centre) + place.margin;
}

// By how much a fixture is larger than its facet: the wall's margin, the tolerance of passing, and
// what Box2D rounds when it puts corners in place (fewer than 8 roundings of the largest number).
double growth(const fw_broadphase &b, const fw_facet &facet, const placed_wall &place)
{
    double largest = magnitude(b.scaled(facet.a)) + magnitude(b.scaled(facet.b)) +
                     b.scale * (facet.length + magnitude(place.centre) + place.margin);
    return b.scale * (place.margin + fw_facet_tolerance(&facet, away(place))) +
           8 * FLT_EPSILON * largest;
}

// Box2D's shapes have a radius by which they are larger than their corners say.
void size_shape(const fw_broadphase &b, const fw_facet &facet, const placed_wall &place,
                b2Shape *shape)
{
    double radius = facet.kind == FW_ROUND ? b.scale * facet.length : 0;
    shape->m_radius = rounded_up(radius + growth(b, facet, place));
}

void add_fixture(const fw_broadphase &b, int number, const placed_wall &place)
{
    const fw_facet &facet = *b.facets[static_cast<size_t>(number)];
    b2EdgeShape edge;
    b2CircleShape circle;
    b2FixtureDef def;
    if (facet.kind == FW_STRAIGHT) {
        edge.SetTwoSided(to_b2(b.scaled(facet.a)), to_b2(b.scaled(facet.b)));
        def.shape = &edge;
        size_shape(b, facet, place, &edge);
    } else {
        circle.m_p = to_b2(b.scaled(facet.a));
        def.shape = &circle;
        size_shape(b, facet, place, &circle);
    }
    def.userData.pointer = static_cast<uintptr_t>(number);
    place.body->CreateFixture(&def);
}

const fw_facet &facet_of(const fw_broadphase &b, b2Fixture *fixture)
{
    return *b.facets[fixture->GetUserData().pointer];
}

bool covers(const placed_wall &place, fw_vec2 displacement)
{
    return std::fabs(displacement.x - place.centre.x) <= place.margin &&
           std::fabs(displacement.y - place.centre.y) <= place.margin;
}

void put_in_place(fw_broadphase &b, placed_wall &place)
{
    for (b2Fixture *f = place.body->GetFixtureList(); f; f = f->GetNext())
        size_shape(b, facet_of(b, f), place, f->GetShape());
    // Brings the tree up to date with the shapes as well: boxes it keeps are larger, never smaller.
    place.body->SetTransform(to_b2(fw_vec2_scale(b.scale, place.centre)), 0);
    // Without a step Box2D's list of moved boxes would grow for ever. A step of no time moves
    // nothing, and no pair forms where nothing is dynamic.
    b.world.Step(0, 0, 0);
}

// Gathers the facets that are really near: Box2D's boxes are fat.
class sieve : public b2QueryCallback
{
  public:
    sieve(const fw_broadphase &broadphase, fw_box asked, int *list, int room)
        : b(broadphase), box(asked), facets(list), capacity(room)
    {
    }

    bool ReportFixture(b2Fixture *fixture) override
    {
        const fw_facet &facet = facet_of(b, fixture);
        const placed_wall &place = b.walls[fixture->GetBody()->GetUserData().pointer];
        const fw_vec2 margin = {place.margin, place.margin};
        // Into the wall's frame, wherever within its margin that is.
        const fw_box around = {fw_vec2_subtract(fw_vec2_subtract(box.low, place.centre), margin),
                               fw_vec2_add(fw_vec2_subtract(box.high, place.centre), margin)};
        if (fw_facet_meets_box(&facet, around, away(place))) {
            if (count < capacity) facets[count] = static_cast<int>(fixture->GetUserData().pointer);
            count += 1;
        }
        return true;
    }

    int found()
    {
        // Every fixture has one box in the tree: none comes twice.
        std::sort(facets, facets + std::min(count, capacity));
        return count;
    }

  private:
    const fw_broadphase &b;
    const fw_box box;
    int *facets;
    int capacity;
    int count = 0;
};

} // namespace

fw_broadphase *fw_broadphase_create(fw_box extent)
{
    try {
        auto *b = new fw_broadphase;
        fw_vec2 size = fw_vec2_subtract(extent.high, extent.low);
        b->origin = fw_vec2_add(extent.low, fw_vec2_scale(0.5, size));
        double span = magnitude(size);
        // A power of two, so that scaling rounds nothing.
        b->scale = span > 0 ? std::exp2(std::floor(std::log2(span_of_scene / span))) : 1;
        return b;
    } catch (...) {
        return nullptr;
    }
}

void fw_broadphase_destroy(fw_broadphase *broadphase)
{
    delete broadphase;
}

int fw_broadphase_add_wall(fw_broadphase *b, const fw_wall *wall)
{
    const size_t first = b->facets.size(), number = b->walls.size();
    b2Body *body = nullptr;
    try {
        b2BodyDef def;
        def.type = fw_wall_moves(wall) ? b2_kinematicBody : b2_staticBody;
        def.userData.pointer = number;
        body = b->world.CreateBody(&def);
        b->walls.push_back({wall, body, {0, 0}, 0, 0});
        for (int i = 0; i < fw_wall_facet_count(wall); ++i) {
            b->facets.push_back(fw_wall_facet(wall, i));
            add_fixture(*b, static_cast<int>(b->facets.size()) - 1, b->walls.back());
        }
        b->world.Step(0, 0, 0); // as in put_in_place()
        b->generation += 1;
        return static_cast<int>(first);
    } catch (...) {
        b->walls.resize(number);
        b->facets.resize(first);
        if (body) b->world.DestroyBody(body);
        return -1;
    }
}

int fw_broadphase_facet_count(const fw_broadphase *b)
{
    return static_cast<int>(b->facets.size());
}

const fw_facet *fw_broadphase_facet(const fw_broadphase *b, int number)
{
    assert(number >= 0 && number < fw_broadphase_facet_count(b));
    return b->facets[static_cast<size_t>(number)];
}

void fw_broadphase_move_wall(fw_broadphase *b, int wall, fw_vec2 displacement, fw_vec2 sweep)
{
    assert(wall >= 0 && static_cast<size_t>(wall) < b->walls.size());
    placed_wall &place = b->walls[static_cast<size_t>(wall)];
    place.sweep = std::hypot(sweep.x, sweep.y);
    if (covers(place, displacement) && covers(place, fw_vec2_add(displacement, sweep))) return;
    // Halfway to where it will be, with room for the way there and for turning back.
    place.centre = fw_vec2_add(displacement, fw_vec2_scale(steps_ahead / 2, sweep));
    place.margin = (steps_ahead / 2 + 1) * magnitude(sweep) + least_margin / b->scale;
    // Where the margin is lost in rounding (a wall that left the scene far behind) it must grow.
    place.margin += 4 * DBL_EPSILON * magnitude(place.centre);
    put_in_place(*b, place);
    b->generation += 1;
}

long fw_broadphase_generation(const fw_broadphase *b)
{
    return b->generation;
}

double fw_broadphase_largest_sweep(const fw_broadphase *b)
{
    double largest = 0;
    for (const placed_wall &place : b->walls) largest = std::max(largest, place.sweep);
    return largest;
}

int fw_broadphase_query(const fw_broadphase *b, fw_box box, int *facets, int capacity)
{
    sieve found(*b, box, facets, capacity);
    const fw_vec2 low = b->scaled(box.low), high = b->scaled(box.high);
    b2AABB asked;
    asked.lowerBound.Set(rounded_down(low.x), rounded_down(low.y));
    asked.upperBound.Set(rounded_up(high.x), rounded_up(high.y));
    b->world.QueryAABB(&found, asked);
    return found.found();
}

struct fw_box_tree {
    fw_vec2 origin;
    double scale; // a power of two
    b2DynamicTree tree;
    std::vector<int32> proxies; // per box, or -1

    b2AABB outward(fw_box box) const
    {
        const fw_vec2 low = fw_vec2_scale(scale, fw_vec2_subtract(box.low, origin));
        const fw_vec2 high = fw_vec2_scale(scale, fw_vec2_subtract(box.high, origin));
        b2AABB rounded;
        rounded.lowerBound.Set(rounded_down(low.x), rounded_down(low.y));
        rounded.upperBound.Set(rounded_up(high.x), rounded_up(high.y));
        return rounded;
    }
};

namespace
{

// Box2D makes its boxes larger by a tenth: little, beside what is in the tree.
constexpr double span_of_boxes = 4096;

class box_list
{
  public:
    box_list(const b2DynamicTree &asked, int *list, int room)
        : tree(asked), numbers(list), capacity(room)
    {
    }

    bool QueryCallback(int32 proxy)
    {
        if (count < capacity)
            numbers[count] = static_cast<int>(reinterpret_cast<uintptr_t>(tree.GetUserData(proxy)));
        count += 1;
        return true;
    }

    int count = 0;

  private:
    const b2DynamicTree &tree;
    int *numbers;
    int capacity;
};

} // namespace

fw_box_tree *fw_box_tree_create(int count, fw_box extent)
{
    try {
        auto made = std::make_unique<fw_box_tree>();
        const fw_vec2 size = fw_vec2_subtract(extent.high, extent.low);
        made->origin = fw_vec2_add(extent.low, fw_vec2_scale(0.5, size));
        const double span = magnitude(size);
        made->scale = span > 0 ? std::exp2(std::floor(std::log2(span_of_boxes / span))) : 1;
        made->proxies.assign(static_cast<size_t>(count), b2_nullNode);
        return made.release();
    } catch (...) {
        return nullptr;
    }
}

void fw_box_tree_destroy(fw_box_tree *tree)
{
    delete tree;
}

void fw_box_tree_put(fw_box_tree *tree, int number, fw_box box)
{
    int32 &proxy = tree->proxies[static_cast<size_t>(number)];
    if (proxy == b2_nullNode)
        proxy = tree->tree.CreateProxy(tree->outward(box),
                                       reinterpret_cast<void *>(static_cast<uintptr_t>(number)));
    else
        tree->tree.MoveProxy(proxy, tree->outward(box), b2Vec2_zero);
}

int fw_box_tree_query(const fw_box_tree *tree, fw_box box, int *numbers, int capacity)
{
    box_list list(tree->tree, numbers, capacity);
    tree->tree.Query(&list, tree->outward(box));
    return list.count;
}
