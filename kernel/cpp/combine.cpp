#include <BOPAlgo_Alerts.hxx>
#include <BRepAlgoAPI_BooleanOperation.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepAlgoAPI_Splitter.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <Standard_Failure.hxx>

#include "brep_common.h"

namespace assemcad {

namespace {

// Where nothing is given the builder leaves without a shape.
void given(const std::vector<TopoDS_Shape>& arguments, const std::vector<TopoDS_Shape>& tools) {
  if (arguments.empty()) {
    throw Refused("there is nothing to work on");
  }
  if (tools.empty()) {
    throw Refused("there is nothing to do it with");
  }
}

template <typename Maker>
TopoDS_Shape run(Maker& maker, const std::vector<TopoDS_Shape>& arguments,
                 const std::vector<TopoDS_Shape>& tools, double tolerance) {
  given(arguments, tools);
  maker.SetArguments(list_of(arguments));
  maker.SetTools(list_of(tools));
  if (tolerance > 0.0) {
    maker.SetFuzzyValue(tolerance);
  }
  // Shapes never change here: the builder may not widen the tolerances of what it is given.
  maker.SetNonDestructive(Standard_True);
  maker.SetRunParallel(Standard_False);
  maker.Build();
  if (maker.GetReport()->HasAlert(STANDARD_TYPE(BOPAlgo_AlertBOPNotAllowed), Message_Fail)) {
    throw Refused("shapes of these kinds do not go together: it takes solids with solids");
  }
  if (maker.HasErrors()) {
    throw Invalid(joined(alerts(maker.GetReport(), Message_Fail)));
  }
  if (!maker.IsDone() || maker.Shape().IsNull()) {
    throw Invalid("the operation did not end");
  }
  return maker.Shape();
}

// A group takes part with each of its children.
std::vector<TopoDS_Shape> members(const TopoDS_Shape& shape) {
  return shape.ShapeType() == TopAbs_COMPOUND ? direct(shape) : std::vector<TopoDS_Shape>{shape};
}

}  // namespace

SolidPtr fuse_all(const Solid& shape, const Bundle& others, bool glue, double tolerance) {
  const TopoDS_Shape& own = shape_of(shape);
  std::vector<TopoDS_Shape> arguments = members(own);
  std::vector<TopoDS_Shape> tools = others.shapes;
  if (own.ShapeType() == TopAbs_COMPOUND) {
    // The children are fused with each other too: only the first one is the argument.
    tools.insert(tools.begin(), arguments.begin() + (arguments.empty() ? 0 : 1), arguments.end());
    arguments.resize(arguments.empty() ? 0 : 1);
    if (arguments.empty() && !tools.empty()) {
      arguments.push_back(tools.front());
      tools.erase(tools.begin());
    }
    if (arguments.size() == 1 && tools.empty()) {
      return wrap(arguments.front());
    }
  }
  BRepAlgoAPI_Fuse maker;
  if (glue) {
    maker.SetGlue(BOPAlgo_GlueShift);
  }
  return wrap(run(maker, arguments, tools, tolerance));
}

SolidPtr cut_all(const Solid& shape, const Bundle& tools, double tolerance) {
  BRepAlgoAPI_Cut maker;
  return wrap(run(maker, members(shape_of(shape)), tools.shapes, tolerance));
}

SolidPtr common_all(const Solid& shape, const Bundle& others, double tolerance) {
  BRepAlgoAPI_Common maker;
  return wrap(run(maker, members(shape_of(shape)), others.shapes, tolerance));
}

SolidPtr split_all(const Solid& shape, const Bundle& tools) {
  BRepAlgoAPI_Splitter maker;
  return wrap(run(maker, {shape_of(shape)}, tools.shapes, 0.0));
}

SolidPtr cleaned(const Solid& shape) {
  const TopoDS_Shape& own = shape_of(shape);
  // Joining faces is a nicety: a failure leaves the shape as it was.
  try {
    ShapeUpgrade_UnifySameDomain tool(own, Standard_True, Standard_True, Standard_True);
    tool.AllowInternalEdges(Standard_False);
    tool.Build();
    return wrap(tool.Shape().IsNull() ? own : tool.Shape());
  } catch (const Standard_Failure&) {
    return wrap(own);
  }
}

}  // namespace assemcad
