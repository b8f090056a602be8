#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "common.h"
#include "integrals.h"
#include "sides.h"

namespace assemcad {

BoundsRaw bounds(const Solid& solid, const Pose& pose) {
  return raw_bounds(tight_box(moved(solid, pose)));
}

MassRaw mass(const Solid& solid) {
  const Integrals found = integrals(shape_of(solid));
  MassRaw out;
  out.volume = found.volume;
  out.area = found.area;
  out.center = xyz(found.center);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      out.inertia[3 * row + column] = found.inertia(row + 1, column + 1) + 0.0;
    }
  }
  return out;
}

CheckRaw check(const Solid& solid) {
  const TopoDS_Shape& shape = shape_of(solid);
  CheckRaw out;
  out.reasons = reasons(shape);
  out.solids = count(shape, TopAbs_SOLID);
  TopTools_IndexedMapOfShape shells;
  TopExp::MapShapes(shape, TopAbs_SHELL, shells);
  out.closed = shells.Extent() > 0;
  for (Standard_Integer i = 1; i <= shells.Extent(); ++i) {
    out.closed = out.closed && BRep_Tool::IsClosed(shells(i));
  }
  return out;
}

// 0 outside, 1 inside, 2 on the boundary.
rust::Vec<std::uint8_t> classify(const Solid& solid, Reals points, double tolerance) {
  const auto sides = Sides::find(shape_of(solid));
  rust::Vec<std::uint8_t> out;
  out.reserve(points.size() / 3);
  for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
    out.push_back(sides->of(gp_Pnt(points[i], points[i + 1], points[i + 2]), tolerance));
  }
  return out;
}

BoresRaw bores(const Solid& solid, const At& from, double radius, double depth) {
  BoresRaw out;
  const auto found = Sides::find(shape_of(solid))->bores(gp_Lin(pnt(from.origin), dir(from.z)), radius, depth);
  out.known = found.has_value();
  if (found) {
    for (const double end : *found) {
      out.ends.push_back(end);
    }
  }
  return out;
}

}  // namespace assemcad
