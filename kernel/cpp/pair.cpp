#include <BRepAlgoAPI_Common.hxx>
#include <BRepBndLib.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>

#include <cmath>

#include "common.h"
#include "integrals.h"

namespace assemcad {

DistanceRaw distance(const Solid& a, const Pose& at_a, const Solid& b, const Pose& at_b) {
  BRepExtrema_DistShapeShape tool(moved(a, at_a), moved(b, at_b), Extrema_ExtFlag_MIN);
  if (!tool.IsDone() || tool.NbSolution() < 1) {
    throw Invalid("the smallest distance was not found");
  }
  DistanceRaw out;
  out.distance = tool.Value();
  out.on_a = xyz(tool.PointOnShape1(1));
  out.on_b = xyz(tool.PointOnShape2(1));
  return out;
}

namespace {

// Intersects two shapes, leaving both as they are; false where their boxes are apart by more than `fuzz`.
bool intersect(BRepAlgoAPI_Common& op, const TopoDS_Shape& first, const TopoDS_Shape& second,
               double fuzz) {
  // The loose boxes, which are quick and never too small: those of free-form faces hold their poles.
  Bnd_Box one;
  Bnd_Box two;
  BRepBndLib::Add(first, one, Standard_False);
  BRepBndLib::Add(second, two, Standard_False);
  one.Enlarge(fuzz);
  if (one.IsOut(two)) {
    return false;
  }
  TopTools_ListOfShape arguments;
  TopTools_ListOfShape tools;
  arguments.Append(first);
  tools.Append(second);
  op.SetArguments(arguments);
  op.SetTools(tools);
  if (fuzz > 0.0) {
    op.SetFuzzyValue(fuzz);
  }
  op.SetNonDestructive(Standard_True);
  op.SetRunParallel(Standard_False);
  op.Build();
  // An unfinished boolean must never look like an empty one.
  if (op.HasErrors()) {
    throw Invalid(joined(alerts(op.GetReport(), Message_Fail)));
  }
  if (!op.IsDone() || op.Shape().IsNull()) {
    throw Invalid("the operation did not end");
  }
  return true;
}

}  // namespace

CommonRaw common_part(const Solid& a, const Pose& at_a, const Solid& b, const Pose& at_b) {
  CommonRaw out{};
  BRepAlgoAPI_Common op;
  if (!intersect(op, moved(a, at_a), moved(b, at_b), 0.0)) {
    return out;
  }
  out.warnings = alerts(op.GetReport(), Message_Warning);
  out.solids = count(op.Shape(), TopAbs_SOLID);
  if (out.solids == 0) {
    return out;
  }
  const Integrals found = integrals(op.Shape());
  out.volume = found.volume;
  if (!(out.volume >= 0.0)) {
    throw Invalid("the common part came out inside-out");
  }
  out.center = xyz(found.center);
  out.bounds = raw_bounds(tight_box(op.Shape()));
  return out;
}

namespace {

// A face by its number in the order of `faces`.
TopoDS_Shape face_of(const TopoDS_Shape& shape, std::uint32_t index) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, TopAbs_FACE, map);
  const Standard_Integer i = static_cast<Standard_Integer>(index) + 1;
  if (i < 1 || i > map.Extent()) {
    throw Refused("there is no face of this number");
  }
  return map(i);
}

// Wider than what placing leaves between faces that touch, narrower than any gap that is meant.
constexpr double FUZZ = 2e-6;

}  // namespace

// The area that two faces in the same surface have in common.
AreaRaw face_common(const Solid& a, const Pose& at_a, std::uint32_t face_a, const Solid& b,
                    const Pose& at_b, std::uint32_t face_b) {
  AreaRaw out{};
  BRepAlgoAPI_Common op;
  const TopoDS_Shape first = face_of(moved(a, at_a), face_a);
  if (!intersect(op, first, face_of(moved(b, at_b), face_b), FUZZ)) {
    return out;
  }
  out.warnings = alerts(op.GetReport(), Message_Warning);
  TopTools_IndexedMapOfShape pieces;
  TopExp::MapShapes(op.Shape(), TopAbs_FACE, pieces);
  for (Standard_Integer i = 1; i <= pieces.Extent(); ++i) {
    // A reversed face counts as much.
    out.area += std::abs(integrals(pieces(i)).area);
  }
  return out;
}

}  // namespace assemcad
