#include "sides.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <ElSLib.hxx>
#include <IntAna_IntLinTorus.hxx>
#include <IntCurvesFace_Intersector.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <list>

#include "flat.h"
#include "shim.h"

namespace assemcad {

namespace {

// How many solids are kept ready: operands and results of the last booleans, and the part asked about.
constexpr std::size_t KEPT = 12;

// A line that passes a surface's tangent by less than this, in mm or as the cosine of an angle, may cross it
// or not.
constexpr double GRAZING = 1e-6;
// What faces may be off, in mm, and a crossing nearer than this to the point says nothing.
constexpr double CLOSE = 1e-7;
// How many times the tolerance a crossing of a free-form face has to be away from the point.
constexpr double AWAY = 10.0;

// A direction may be turned by this and is still square to a face, and what a hole has nothing to do with is
// farther from it than this, in mm.
constexpr double SQUARE = 1e-9;
constexpr double BESIDE = 1e-3;

// Directions of no part's symmetry, each far from the others.
const std::array<gp_Dir, 5>& ways() {
  static const std::array<gp_Dir, 5> all{
      gp_Dir(0.371390676, 0.557086014, 0.742781353), gp_Dir(-0.684210527, 0.431578948, 0.587894736),
      gp_Dir(0.513157895, -0.789473684, 0.336842105), gp_Dir(-0.447214, -0.311827, -0.838341),
      gp_Dir(0.801783726, 0.267261242, -0.534522484)};
  return all;
}

// The roots of a t^2 + 2 b t + c. False where it is too close to tell how many there are.
bool roots(double a, double b, double c, double size, std::vector<double>& out) {
  const double scale = std::max({std::abs(a) * size * size, std::abs(b) * size, std::abs(c)});
  if (scale <= 0.0) {
    return false;
  }
  if (std::abs(a) * size * size < 1e-12 * scale) {
    return false;
  }
  const double discriminant = b * b - a * c;
  if (discriminant < 0.0) {
    return true;
  }
  const double root = std::sqrt(discriminant);
  const double q = b >= 0.0 ? -b - root : -b + root;
  if (q == 0.0) {
    return false;
  }
  out.push_back(q / a);
  out.push_back(c / q);
  return true;
}

}  // namespace

// A face, and what is needed to ask it.
struct Sides::Wall {
  TopoDS_Face face;
  BRepAdaptor_Surface surface;
  GeomAbs_SurfaceType type;
  std::array<double, 6> box{};
  double tolerance;
  // Made where a line meets the face.
  std::unique_ptr<Flat> flat;
  std::unique_ptr<BRepTopAdaptor_FClass2d> trim;
  Handle(IntCurvesFace_Intersector) free;

  explicit Wall(const TopoDS_Face& of)
      : face(of), surface(of, Standard_False), type(surface.GetType()), tolerance(BRep_Tool::Tolerance(of)) {
    Bnd_Box around;
    BRepBndLib::Add(face, around, Standard_False);
    if (around.IsVoid() || around.IsOpen()) {
      throw Invalid("a face has no extent");
    }
    around.Get(box[0], box[1], box[2], box[3], box[4], box[5]);
  }

  bool known() const {
    return type == GeomAbs_Plane || type == GeomAbs_Cylinder || type == GeomAbs_Cone ||
           type == GeomAbs_Sphere || type == GeomAbs_Torus;
  }

  bool about(const gp_Pnt& at, double by) const {
    return at.X() >= box[0] - by && at.X() <= box[3] + by && at.Y() >= box[1] - by &&
           at.Y() <= box[4] + by && at.Z() >= box[2] - by && at.Z() <= box[5] + by;
  }

  // Whether a half line comes through the box.
  bool meets(const gp_Lin& line) const {
    const gp_XYZ o = line.Location().XYZ(), d = line.Direction().XYZ();
    double from = -CLOSE, to = RealLast();
    for (int axis = 1; axis <= 3; ++axis) {
      // No direction of ours lies in a plane of two axes.
      const double a = (box[axis - 1] - CLOSE - o.Coord(axis)) / d.Coord(axis);
      const double b = (box[axis + 2] + CLOSE - o.Coord(axis)) / d.Coord(axis);
      from = std::max(from, std::min(a, b));
      to = std::min(to, std::max(a, b));
    }
    return from <= to;
  }

  // Where the foot of a point on the surface is.
  gp_XY place(const gp_Pnt& at) const {
    double u = 0.0, v = 0.0;
    switch (type) {
      case GeomAbs_Plane:
        ElSLib::Parameters(surface.Plane(), at, u, v);
        break;
      case GeomAbs_Cylinder:
        ElSLib::Parameters(surface.Cylinder(), at, u, v);
        break;
      case GeomAbs_Cone:
        ElSLib::Parameters(surface.Cone(), at, u, v);
        break;
      case GeomAbs_Sphere:
        ElSLib::Parameters(surface.Sphere(), at, u, v);
        break;
      default:
        ElSLib::Parameters(surface.Torus(), at, u, v);
    }
    return {u, v};
  }

  Within holds(const gp_XY& uv) {
    if (type == GeomAbs_Plane) {
      if (!flat) {
        flat = std::make_unique<Flat>(face, surface.Plane().Position());
      }
      const Within found = flat->holds(uv);
      if (found != Within::UNSURE) {
        return found;
      }
    }
    if (!trim) {
      trim = std::make_unique<BRepTopAdaptor_FClass2d>(face, CLOSE);
    }
    switch (trim->Perform(gp_Pnt2d(uv), Standard_True)) {
      case TopAbs_IN:
        return Within::YES;
      case TopAbs_OUT:
        return Within::NO;
      default:
        return Within::UNSURE;
    }
  }

  // Whether a place off the face, as `holds` has it, is farther from its edges than a length.
  bool clear(const gp_XY& uv, double by) const {
    if (type == GeomAbs_Plane) {
      return flat && flat->clear(uv) > by;
    }
    if (type != GeomAbs_Cylinder || !trim) {
      return false;
    }
    const double most = by * std::max(1.0, 1.0 / surface.Cylinder().Radius());
    return trim->TestOnRestriction(gp_Pnt2d(uv), most, Standard_True) == TopAbs_OUT;
  }

  // Whether a hole has nothing to do with the face: for sure, not wherever it is so.
  bool misses(const gp_Lin& axis, double radius) const {
    const gp_XYZ d = axis.Direction().XYZ(), p = axis.Location().XYZ();
    if (type == GeomAbs_Plane) {
      const gp_Ax3 own = surface.Plane().Position();
      const gp_XYZ normal = own.Direction().XYZ();
      return std::abs(normal.Dot(d)) < SQUARE &&
             std::abs((p - own.Location().XYZ()).Dot(normal)) > radius + BESIDE;
    }
    if (type == GeomAbs_Cylinder) {
      const gp_Ax3 own = surface.Cylinder().Position();
      const double apart = axis.Distance(own.Location());
      return own.Direction().XYZ().Crossed(d).Modulus() < SQUARE &&
             std::abs(apart - surface.Cylinder().Radius()) > radius + BESIDE;
    }
    return false;
  }

  // How far a point is from the surface, borders aside.
  double gap(const gp_Pnt& at) const {
    const gp_Ax3 own = type == GeomAbs_Plane      ? surface.Plane().Position()
                       : type == GeomAbs_Cylinder ? surface.Cylinder().Position()
                       : type == GeomAbs_Cone     ? surface.Cone().Position()
                       : type == GeomAbs_Sphere   ? surface.Sphere().Position()
                                                  : surface.Torus().Position();
    const gp_XYZ arm = at.XYZ() - own.Location().XYZ();
    const double up = arm.Dot(own.Direction().XYZ());
    const double off = (arm - up * own.Direction().XYZ()).Modulus();
    switch (type) {
      case GeomAbs_Plane:
        return std::abs(up);
      case GeomAbs_Cylinder:
        return std::abs(off - surface.Cylinder().Radius());
      case GeomAbs_Cone: {
        const double angle = surface.Cone().SemiAngle();
        const double wide = surface.Cone().RefRadius() * std::cos(angle) + up * std::sin(angle);
        // Both sides of the tip.
        return std::min(std::abs(off * std::cos(angle) - wide), std::abs(off * std::cos(angle) + wide));
      }
      case GeomAbs_Sphere:
        return std::abs(arm.Modulus() - surface.Sphere().Radius());
      default:
        return std::abs(std::hypot(off - surface.Torus().MajorRadius(), up) - surface.Torus().MinorRadius());
    }
  }

  // Where a line meets the surface. False where that is too close to tell.
  bool meetings(const gp_Lin& line, std::vector<double>& out) const {
    const gp_XYZ d = line.Direction().XYZ();
    if (type == GeomAbs_Torus) {
      const IntAna_IntLinTorus found(line, surface.Torus());
      for (int i = 1; found.IsDone() && i <= found.NbPoints(); ++i) {
        out.push_back(found.ParamOnLine(i));
      }
      return found.IsDone();
    }
    if (type == GeomAbs_Sphere) {
      const gp_XYZ arm = line.Location().XYZ() - surface.Sphere().Location().XYZ();
      const double r = surface.Sphere().Radius(), b = arm.Dot(d);
      const double least = (arm - b * d).Modulus();
      return std::abs(least - r) > GRAZING && roots(1.0, b, arm.SquareModulus() - r * r, r, out);
    }
    const gp_Ax3 own = type == GeomAbs_Plane      ? surface.Plane().Position()
                       : type == GeomAbs_Cylinder ? surface.Cylinder().Position()
                                                  : surface.Cone().Position();
    const gp_XYZ axis = own.Direction().XYZ(), arm = line.Location().XYZ() - own.Location().XYZ();
    const double up = arm.Dot(axis), along = d.Dot(axis);
    if (type == GeomAbs_Plane) {
      if (std::abs(along) < GRAZING) {
        return false;
      }
      out.push_back(-up / along);
      return true;
    }
    const gp_XYZ off = arm - up * axis, beside = d - along * axis;
    if (type == GeomAbs_Cylinder) {
      const double r = surface.Cylinder().Radius(), a = beside.SquareModulus(), b = off.Dot(beside);
      if (a < GRAZING) {
        return false;
      }
      const double least = (off - b / a * beside).Modulus();
      return std::abs(least - r) > GRAZING && roots(a, b, off.SquareModulus() - r * r, r, out);
    }
    const double slope = std::tan(surface.Cone().SemiAngle());
    const double wide = surface.Cone().RefRadius() + up * slope, widens = along * slope;
    const double a = beside.SquareModulus() - widens * widens, b = off.Dot(beside) - wide * widens;
    const double size = std::max({std::abs(wide), off.Modulus(), 1.0});
    const double c = off.SquareModulus() - wide * wide;
    return std::abs(b * b - a * c) > GRAZING * size * size && roots(a, b, c, size, out);
  }

  // Counts where a half line crosses the face. False where that is too close to tell.
  bool crossed(const gp_Lin& line, double tolerance, Crossings& all) {
    const auto count = [&](double t, bool leaving) {
      ++all.count;
      if (t < all.nearest) {
        all.nearest = t;
        all.leaving = leaving;
      }
    };
    if (!known()) {
      if (free.IsNull()) {
        free = new IntCurvesFace_Intersector(face, CLOSE);
      }
      const double near = AWAY * std::max(tolerance, CLOSE);
      free->Perform(line, -near, RealLast());
      if (!free->IsDone() || free->IsParallel()) {
        return false;
      }
      for (int i = 1; i <= free->NbPnt(); ++i) {
        const auto way = free->Transition(i);
        if (free->State(i) != TopAbs_IN || way == IntCurveSurface_Tangent || free->WParameter(i) < near) {
          return false;
        }
        // Of a reversed face the transition is that of its own side.
        count(free->WParameter(i), way == IntCurveSurface_Out);
      }
      return true;
    }
    std::vector<double> found;
    if (!meetings(line, found)) {
      return false;
    }
    for (const double t : found) {
      if (t < -CLOSE) {
        continue;
      }
      const gp_Pnt at(line.Location().XYZ() + t * line.Direction().XYZ());
      if (!about(at, CLOSE)) {
        continue;
      }
      const gp_XY uv = place(at);
      const Within within = holds(uv);
      if (within == Within::NO) {
        continue;
      }
      gp_Pnt on;
      gp_Vec along_u, along_v;
      surface.D1(uv.X(), uv.Y(), on, along_u, along_v);
      gp_XYZ normal = along_u.Crossed(along_v).XYZ();
      const double size = normal.Modulus();
      if (within == Within::UNSURE || t < CLOSE || size <= gp::Resolution() || on.Distance(at) > GRAZING) {
        return false;
      }
      const double steep = normal.Dot(line.Direction().XYZ()) / size;
      if (std::abs(steep) < GRAZING) {
        return false;
      }
      count(t, (steep > 0.0) != (face.Orientation() == TopAbs_REVERSED));
    }
    return true;
  }
};

Sides::Sides(const TopoDS_Shape& solid) : shape(solid) {
  try {
    for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) {
      const TopoDS_Face& face = TopoDS::Face(it.Current());
      plain = plain && (face.Orientation() == TopAbs_FORWARD || face.Orientation() == TopAbs_REVERSED);
      walls.push_back(std::make_unique<Wall>(face));
    }
  } catch (const Standard_Failure&) {
    plain = false;
  } catch (const Invalid&) {
    plain = false;
  }
}

Sides::~Sides() = default;

// On the surface for sure, where it may be on it; else none, and `near` where OCCT has to be asked.
std::optional<Sides::Side> Sides::touched(const gp_Pnt& at, double tolerance, bool& near) const {
  for (const auto& wall : walls) {
    if (!wall->known() || !wall->about(at, tolerance)) {
      continue;
    }
    const double gap = wall->gap(at);
    if (gap > tolerance + wall->tolerance) {
      continue;
    }
    const gp_XY uv = wall->place(at);
    const Within within = wall->holds(uv);
    // Where the foot is on an edge, so is the point.
    if (gap <= tolerance && within != Within::NO) {
      return BOUNDARY;
    }
    if (within != Within::NO || !wall->clear(uv, tolerance + wall->tolerance)) {
      near = true;
    }
  }
  return std::nullopt;
}

std::optional<Sides::Side> Sides::along(const gp_Lin& line, double tolerance) const {
  Crossings all;
  for (const auto& wall : walls) {
    if (wall->meets(line) && !wall->crossed(line, tolerance, all)) {
      return std::nullopt;
    }
  }
  const bool odd = all.count % 2 == 1;
  if (all.count > 0 && odd != all.leaving) {
    return std::nullopt;
  }
  return odd ? INSIDE : OUTSIDE;
}

Sides::Side Sides::of(const gp_Pnt& at, double tolerance) {
  if (!plain) {
    return asked(at, tolerance);
  }
  try {
    bool near = false;
    if (const auto on = touched(at, tolerance, near)) {
      return *on;
    }
    if (near) {
      return asked(at, tolerance);
    }
    std::optional<Side> first;
    for (const gp_Dir& way : ways()) {
      const auto found = along(gp_Lin(at, way), tolerance);
      if (!found) {
        continue;
      }
      if (first) {
        return *first == *found ? *found : asked(at, tolerance);
      }
      first = found;
    }
  } catch (const Standard_Failure&) {
    plain = false;
  } catch (const Invalid&) {
    plain = false;
  }
  return asked(at, tolerance);
}

std::optional<std::vector<double>> Sides::bores(const gp_Lin& axis, double radius, double depth) {
  const gp_XYZ p = axis.Location().XYZ(), d = axis.Direction().XYZ();
  // The hole's box: of its axis, wider by the radius.
  Bnd_Box around;
  around.Add(gp_Pnt(p));
  around.Add(gp_Pnt(p + depth * d));
  around.Enlarge(radius + BESIDE);
  std::vector<std::pair<double, bool>> met;
  for (const auto& wall : walls) {
    const auto& b = wall->box;
    Bnd_Box own;
    own.Update(b[0], b[1], b[2], b[3], b[4], b[5]);
    if (around.IsOut(own) || wall->misses(axis, radius)) {
      continue;
    }
    if (!plain || wall->type != GeomAbs_Plane) {
      return std::nullopt;
    }
    const gp_Pln plane = wall->surface.Plane();
    gp_XYZ normal = plane.Position().XDirection().XYZ().Crossed(plane.Position().YDirection().XYZ());
    if (wall->face.Orientation() == TopAbs_REVERSED) {
      normal.Reverse();
    }
    if (normal.Crossed(d).Modulus() > SQUARE) {
      return std::nullopt;
    }
    const double at = (plane.Location().XYZ() - p).Dot(normal) / d.Dot(normal);
    const gp_XY uv = wall->place(gp_Pnt(p + at * d));
    const Within within = wall->holds(uv);
    if (within == Within::UNSURE || !wall->clear(uv, radius + BESIDE)) {
      return std::nullopt;
    }
    if (within == Within::YES) {
      met.emplace_back(at, normal.Dot(d) > 0.0);
    }
  }
  std::sort(met.begin(), met.end());
  std::vector<double> out;
  const auto stretch = [&](double from, double to) {
    if (to - from > CLOSE) {
      out.push_back(from);
      out.push_back(to);
    }
  };
  // Where nothing is met, the hole is all in the material or all out of it.
  bool in = met.empty() ? of(gp_Pnt(p + 0.5 * depth * d), CLOSE) == INSIDE : met.front().second;
  double from = 0.0;
  for (const auto& [at, leaves] : met) {
    if (leaves != in) {
      return std::nullopt;
    }
    const double to = std::clamp(at, 0.0, depth);
    if (in) {
      stretch(from, to);
    }
    in = !in;
    from = to;
  }
  if (in) {
    stretch(from, depth);
  }
  return out;
}

Sides::Side Sides::asked(const gp_Pnt& at, double tolerance) {
  if (!classifier) {
    classifier.emplace(shape);
  }
  classifier->Perform(at, tolerance);
  switch (classifier->State()) {
    case TopAbs_OUT:
      return OUTSIDE;
    case TopAbs_IN:
      return INSIDE;
    case TopAbs_ON:
      return BOUNDARY;
    default:
      throw Invalid("a point is neither inside nor outside");
  }
}

std::shared_ptr<Sides> Sides::find(const TopoDS_Shape& solid) {
  // Never taken down: OCCT's own statics may be gone by then.
  thread_local auto& kept = *new std::list<std::shared_ptr<Sides>>();
  for (auto it = kept.begin(); it != kept.end(); ++it) {
    if ((*it)->shape.IsEqual(solid)) {
      kept.splice(kept.begin(), kept, it);
      return kept.front();
    }
  }
  kept.push_front(std::make_shared<Sides>(solid));
  if (kept.size() > KEPT) {
    kept.pop_back();
  }
  return kept.front();
}

}  // namespace assemcad
