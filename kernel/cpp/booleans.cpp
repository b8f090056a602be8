#include <BRepAlgoAPI_BooleanOperation.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>

#include "common.h"

namespace assemcad {

// Kinds: 0 fuse, 1 cut, 2 common. What comes back is the builder's compound, unjudged but for its
// own errors: whoever asks counts the solids, compares the volumes and weighs the warnings.
BooleanRaw boolean(const Solid& a, const Solid& b, std::uint8_t kind) {
  BRepAlgoAPI_BooleanOperation op;
  TopTools_ListOfShape arguments;
  TopTools_ListOfShape tools;
  arguments.Append(shape_of(a));
  tools.Append(shape_of(b));
  op.SetArguments(arguments);
  op.SetTools(tools);
  op.SetOperation(kind == 0 ? BOPAlgo_FUSE : kind == 1 ? BOPAlgo_CUT : BOPAlgo_COMMON);
  op.SetNonDestructive(Standard_True);
  op.SetRunParallel(Standard_False);
  op.Build();
  if (op.HasErrors()) {
    throw Invalid(joined(alerts(op.GetReport(), Message_Fail)));
  }
  if (!op.IsDone()) {
    throw Invalid("the operation did not end");
  }
  BooleanRaw out;
  out.solid = wrap(op.Shape());
  out.warnings = alerts(op.GetReport(), Message_Warning);
  return out;
}

PartsRaw parts(const Solid& solid) {
  PartsRaw out;
  out.solids = count(shape_of(solid), TopAbs_SOLID);
  out.loose = 0;
  for (TopExp_Explorer it(solid.shape, TopAbs_FACE, TopAbs_SOLID); it.More(); it.Next()) {
    ++out.loose;
  }
  return out;
}

SolidPtr only_solid(const Solid& solid) {
  TopExp_Explorer it(shape_of(solid), TopAbs_SOLID);
  if (!it.More()) {
    throw Invalid("there is no solid");
  }
  return wrap(it.Current());
}

SolidPtr unify(const Solid& solid) {
  ShapeUpgrade_UnifySameDomain tool(shape_of(solid), Standard_True, Standard_True,
                                    Standard_False);
  tool.AllowInternalEdges(Standard_False);
  tool.Build();
  return wrap(tool.Shape());
}

}  // namespace assemcad
