#include <BRepAlgoAPI_Common.hxx>
#include <BRepBndLib.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <TopTools_ListOfShape.hxx>

#include "common.h"

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

CommonRaw common_part(const Solid& a, const Pose& at_a, const Solid& b, const Pose& at_b) {
  CommonRaw out{};
  const TopoDS_Shape first = moved(a, at_a);
  const TopoDS_Shape second = moved(b, at_b);
  // The loose boxes, which are quick and never too small: those of free-form faces hold their poles.
  Bnd_Box one;
  Bnd_Box two;
  BRepBndLib::Add(first, one, Standard_False);
  BRepBndLib::Add(second, two, Standard_False);
  if (one.IsOut(two)) {
    return out;
  }
  BRepAlgoAPI_Common op;
  TopTools_ListOfShape arguments;
  TopTools_ListOfShape tools;
  arguments.Append(first);
  tools.Append(second);
  op.SetArguments(arguments);
  op.SetTools(tools);
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
  out.warnings = alerts(op.GetReport(), Message_Warning);
  out.solids = count(op.Shape(), TopAbs_SOLID);
  if (out.solids == 0) {
    return out;
  }
  const GProp_GProps props = volume_props(op.Shape());
  out.volume = props.Mass();
  if (!(out.volume >= 0.0)) {
    throw Invalid("the common part came out inside-out");
  }
  out.center = xyz(props.CentreOfMass());
  out.bounds = raw_bounds(tight_box(op.Shape()));
  return out;
}

}  // namespace assemcad
