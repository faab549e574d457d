// The parts of a drawn world, for its own source files only: shapes in pixels, bodies, joints and contacts.
#pragma once

#include <optional>
#include <string>

#include <cairn/math/list.hpp>
#include "render/draw.hpp"

namespace cairn::render {

using Outline = List<Point>;  // [px] a convex polygon

/// A pose that can be drawn: finite, and not so far away that pixels lose their precision.
bool is_drawable(const Camera& camera, const Pose<double>& pose);
/// A pose whose body can be drawn, if only a part of it: finite, and not absurdly far away.
bool has_place(const Camera& camera, const Pose<double>& pose);
/// With a place, and at least near the viewport.
bool is_seen(const Camera& camera, const SnapshotBody& body);

/// Whether it has no inside.
bool is_line(const Shape<double>& shape);
/// The shape as a polygon that deviates by less than a quarter of a pixel. A segment has no area: 2 points. A
/// chain is no polygon: none.
Outline outline_of(const Camera& camera, const Pose<double>& pose, const Shape<double>& shape);
/// What of a convex polygon is inside a rectangle, or inside another convex polygon.
Outline clipped(const Outline& outline, const Rect& rect);
Outline common_part(const Outline& a, const Outline& b);
double area(const Outline& outline);  // [px^2]

void paint_shape(Canvas& canvas, const Camera& camera, const Pose<double>& pose, const Shape<double>& shape,
                 const Paint& paint);

/// Whether edge i of a shape, from its vertex i on, lies between two pieces of the body's outline.
bool is_seam(const SnapshotBody& body, const Shape<double>& shape, int edge);
/// The outlines that the body's pieces make up, and thin lines between the pieces.
void draw_outlines(Canvas& canvas, const Camera& camera, const SnapshotBody& body, const Stroke& stroke);

/// Its line, with short strokes on the side of its solid, as ground is marked in drawings of machines.
void paint_chain(Canvas& canvas, const Camera& camera, const Pose<double>& pose, const Chain<double>& chain,
                 const Paint& paint);

/// How deep inside the shape a point of the body's frame is [m]; negative outside.
double depth_in(const Shape<double>& shape, const Vec2<double>& local);
/// The largest depth in any of a body's shapes [m].
double depth_in(const SnapshotBody& body, const Vec2<double>& local);
/// How far it is from the centre of mass to the surface along a direction of the body's frame [m]; 0 if the
/// centre of mass is outside.
double reach(const SnapshotBody& body, const Vec2<double>& direction);

std::string name_of(const WorldLook& look, BodyId body);
/// The size [px] at which a body's name is written in its middle; 0 if there is no room for it.
double name_size(const Page& page, const Camera& camera, const SnapshotBody& body, const std::string& name);

void draw_static_body(Page& page, const Camera& camera, const SnapshotBody& body, BodyId id);
void draw_dynamic_body(Page& page, const Camera& camera, const SnapshotBody& body, BodyId id,
                       const WorldLook& look);
/// Marks along a surface that runs, which go with it: `time` [s] is that of the picture.
void draw_belt(Page& page, const Camera& camera, const SnapshotBody& body, BodyId id, double time);
/// Marks along the surface of what is one-way: they point to where it holds off what comes.
void draw_one_way(Page& page, const Camera& camera, const SnapshotBody& body);
void write_name(Page& page, const Camera& camera, const SnapshotBody& body, BodyId id, const WorldLook& look);

/// What is seen behind everything: water, points that attract, wind, and the ways that bodies are led along.
void draw_fields(Page& page, const Camera& camera, const Snapshot& snapshot);
/// Forces and torques from outside that act on bodies: the longest arrow is the largest of them, and the bow
/// that goes furthest around the largest torque.
void draw_outer_forces(Page& page, const Camera& camera, const Snapshot& snapshot);

/// What is seen behind the bodies: rods, and the arms of pins that are outside their body.
void draw_joint_lines(Page& page, const Camera& camera, const Snapshot& snapshot);
/// What is seen upon them: where the joints are fastened.
void draw_joint_ends(Page& page, const Camera& camera, const Snapshot& snapshot);
/// What a joint has besides: the groove that it slides in, a spring, the teeth of a ratchet, the box of a
/// servo.
void draw_joint_marks(Page& page, const Camera& camera, const Snapshot& snapshot, const SnapshotJoint& joint);
/// What is left of joints that have broken: their ends.
void draw_broken_joints(Page& page, const Camera& camera, const Snapshot& snapshot);

void draw_penetrations(Page& page, const Camera& camera, const Snapshot& snapshot);
void draw_contacts(Page& page, const Camera& camera, const Snapshot& snapshot, const WorldLook& look);

/// Writes inside `within` where no other text is, rather on no line than on one; nothing, if there is no
/// room.
bool write_if_free(Page& page, const List<Point>& places, const Rect& within, const std::string& text,
                   const TextStyle& style);

/// A body of the snapshot, or none if the number names none.
const SnapshotBody* body_of(const Snapshot& snapshot, BodyId id);

}  // namespace cairn::render
