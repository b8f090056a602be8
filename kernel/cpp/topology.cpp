#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepTools.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>

#include "brep_common.h"

namespace assemcad {

void Bundle::push(const Solid& shape) { shapes.push_back(shape_of(shape)); }

SolidPtr Bundle::at(std::uint32_t index) const {
  if (index >= shapes.size()) {
    throw Refused("there is no shape of this number");
  }
  return wrap(shapes[index]);
}

BundlePtr bundle() { return std::make_unique<Bundle>(); }

TopAbs_ShapeEnum kind_named(std::uint8_t kind) {
  if (kind > static_cast<std::uint8_t>(TopAbs_VERTEX)) {
    throw Refused("there is no such kind of shape");
  }
  return static_cast<TopAbs_ShapeEnum>(kind);
}

TopoDS_Face face_in(const TopoDS_Shape& shape) {
  if (shape.IsNull() || shape.ShapeType() != TopAbs_FACE) {
    throw Refused("it is no face");
  }
  return TopoDS::Face(shape);
}

TopoDS_Wire wire_in(const TopoDS_Shape& shape) {
  if (!shape.IsNull() && shape.ShapeType() == TopAbs_WIRE) {
    if (direct(shape).empty()) {
      throw Refused("a wire of it has no edges");
    }
    return TopoDS::Wire(shape);
  }
  if (shape.IsNull() || shape.ShapeType() != TopAbs_EDGE) {
    throw Refused("it takes wires and edges only");
  }
  BRepBuilderAPI_MakeWire maker(TopoDS::Edge(shape));
  if (!maker.IsDone()) {
    throw Refused("an edge of it makes no wire");
  }
  return maker.Wire();
}

std::vector<TopoDS_Shape> distinct(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, kind, map);
  std::vector<TopoDS_Shape> out;
  for (Standard_Integer i = 1; i <= map.Extent(); ++i) {
    out.push_back(map(i));
  }
  return out;
}

std::vector<TopoDS_Shape> direct(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Shape> out;
  for (TopoDS_Iterator it(shape); it.More(); it.Next()) {
    out.push_back(it.Value());
  }
  return out;
}

bool holds(const TopoDS_Shape& shape, const TopoDS_Shape& part) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, part.ShapeType(), map);
  return map.Contains(part);
}

TopTools_ListOfShape list_of(const std::vector<TopoDS_Shape>& shapes) {
  TopTools_ListOfShape out;
  for (const TopoDS_Shape& shape : shapes) {
    out.Append(shape);
  }
  return out;
}

TopoDS_Shape compound_from(const std::vector<TopoDS_Shape>& shapes) {
  BRep_Builder builder;
  TopoDS_Compound out;
  builder.MakeCompound(out);
  for (const TopoDS_Shape& shape : shapes) {
    builder.Add(out, shape);
  }
  return out;
}

TopoDS_Wire outer_of(const TopoDS_Face& face) {
  const TopoDS_Wire outer = BRepTools::OuterWire(face);
  if (outer.IsNull()) {
    throw Refused("the face has no border");
  }
  return outer;
}

std::vector<TopoDS_Shape> inner_of(const TopoDS_Face& face) {
  const TopoDS_Wire outer = outer_of(face);
  std::vector<TopoDS_Shape> out;
  for (const TopoDS_Shape& wire : distinct(face, TopAbs_WIRE)) {
    if (!wire.IsSame(outer)) {
      out.push_back(wire);
    }
  }
  return out;
}

namespace {

// The corners of a wire in the order in which it is walked.
std::vector<TopoDS_Shape> corners(const TopoDS_Wire& wire) {
  std::vector<TopoDS_Shape> out;
  BRepTools_WireExplorer it(wire);
  for (; it.More(); it.Next()) {
    out.push_back(it.CurrentVertex());
  }
  if (!out.empty() && !BRep_Tool::IsClosed(wire) && !it.CurrentVertex().IsNull()) {
    out.push_back(it.CurrentVertex());
  }
  return out;
}

}  // namespace

std::uint8_t kind_of(const Solid& shape) {
  return static_cast<std::uint8_t>(shape_of(shape).ShapeType());
}

BundlePtr parts_of(const Solid& shape, std::uint8_t kind) {
  const TopAbs_ShapeEnum wanted = kind_named(kind);
  const TopoDS_Shape& from = shape_of(shape);
  BundlePtr out = bundle();
  if (wanted == TopAbs_VERTEX && from.ShapeType() == TopAbs_WIRE && !direct(from).empty()) {
    out->shapes = corners(TopoDS::Wire(from));
    return out;
  }
  for (const TopoDS_Shape& part : distinct(from, wanted)) {
    // The pole of a sphere or the tip of a cone is no edge that anybody would choose.
    if (wanted != TopAbs_EDGE || !BRep_Tool::Degenerated(TopoDS::Edge(part))) {
      out->shapes.push_back(part);
    }
  }
  return out;
}

BundlePtr ancestors_of(const Solid& context, const Solid& of, std::uint8_t kind) {
  const TopAbs_ShapeEnum wanted = kind_named(kind);
  const TopoDS_Shape& part = shape_of(of);
  if (wanted > part.ShapeType()) {
    throw Refused("what holds a shape is of no lower kind than the shape");
  }
  TopTools_IndexedDataMapOfShapeListOfShape map;
  TopExp::MapShapesAndAncestors(shape_of(context), part.ShapeType(), wanted, map);
  const Standard_Integer index = map.FindIndex(part);
  if (index == 0) {
    throw Refused("the shape is no part of the other one");
  }
  // A face that closes onto itself holds its seam twice.
  TopTools_IndexedMapOfShape once;
  BundlePtr out = bundle();
  for (const TopoDS_Shape& holder : map(index)) {
    if (!once.Contains(holder)) {
      once.Add(holder);
      out->shapes.push_back(holder);
    }
  }
  return out;
}

SolidPtr compound_of(const Bundle& shapes) { return wrap(compound_from(shapes.shapes)); }

BundlePtr children_of(const Solid& shape) {
  const TopoDS_Shape& from = shape_of(shape);
  BundlePtr out = bundle();
  if (from.ShapeType() != TopAbs_WIRE || direct(from).empty()) {
    out->shapes = direct(from);
    return out;
  }
  for (BRepTools_WireExplorer it(TopoDS::Wire(from)); it.More(); it.Next()) {
    out->shapes.push_back(it.Current());
  }
  return out;
}

bool same_shape(const Solid& a, const Solid& b) { return a.shape.IsSame(b.shape); }

SolidPtr another_handle(const Solid& shape) { return wrap(shape_of(shape)); }

SolidPtr shape_moved(const Solid& shape, const Pose& pose) { return wrap(moved(shape, pose)); }

SolidPtr shape_mirrored(const Solid& shape, const Vector& point, const Vector& normal) {
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2(pnt(point), dir(normal)));
  BRepBuilderAPI_Transform maker(shape_of(shape), mirror, Standard_True);
  if (!maker.IsDone()) {
    throw Invalid("it could not be mirrored");
  }
  return wrap(maker.Shape());
}

}  // namespace assemcad
