#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepLib_FindSurface.hxx>
#include <BRep_Tool.hxx>
#include <ShapeFix_Face.hxx>
#include <ShapeFix_Shape.hxx>
#include <TopoDS.hxx>

#include "brep_common.h"

namespace assemcad {

namespace {

// The first wire is the outer one, the others are borders too: which of them are holes in which is
// told by how they nest, so that more than one face may come out.
TopoDS_Shape face_from(const Bundle& wires) {
  if (wires.shapes.empty()) {
    throw Refused("there is no outline");
  }
  std::vector<TopoDS_Shape> borders;
  for (const TopoDS_Shape& shape : wires.shapes) {
    borders.push_back(wire_in(shape));
    if (!BRep_Tool::IsClosed(borders.back())) {
      throw Refused("an outline of it is not closed");
    }
  }
  if (!BRepLib_FindSurface(compound_from(borders), -1.0, Standard_True).Found()) {
    throw Refused("its outlines do not lie in one plane");
  }
  ShapeFix_Shape fix(borders.front());
  fix.Perform();
  const TopoDS_Shape outer = fix.Shape();
  if (outer.IsNull() || outer.ShapeType() != TopAbs_WIRE) {
    throw Invalid("its outer outline falls apart");
  }
  BRepBuilderAPI_MakeFace maker(TopoDS::Wire(outer), Standard_True);
  if (!maker.IsDone()) {
    throw Refused("its outer outline bounds no flat face");
  }
  for (std::size_t i = 1; i < borders.size(); ++i) {
    maker.Add(TopoDS::Wire(borders[i]));
  }
  if (!maker.IsDone()) {
    throw Refused("its outlines bound no flat face");
  }
  ShapeFix_Face orient(maker.Face());
  orient.FixOrientation();
  orient.Perform();
  const TopoDS_Shape out = orient.Result();
  if (out.IsNull() || distinct(out, TopAbs_FACE).empty()) {
    throw Invalid("no face came out");
  }
  return out;
}

}  // namespace

SolidPtr face_of_wires(const Bundle& wires) { return wrap(face_from(wires)); }

BundlePtr faces_of_wires(const Bundle& wires) {
  BundlePtr out = bundle();
  out->shapes = distinct(face_from(wires), TopAbs_FACE);
  return out;
}

SolidPtr outer_wire_of(const Solid& face) { return wrap(outer_of(face_in(shape_of(face)))); }

BundlePtr inner_wires_of(const Solid& face) {
  BundlePtr out = bundle();
  out->shapes = inner_of(face_in(shape_of(face)));
  return out;
}

}  // namespace assemcad
