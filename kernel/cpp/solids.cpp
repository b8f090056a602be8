#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepOffsetAPI_MakeThickSolid.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepPrimAPI_MakeWedge.hxx>
#include <ShapeFix_Shape.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>

#include <cmath>

#include "brep_common.h"
#include "integrals.h"

namespace assemcad {

namespace {

void body(const TopoDS_Shape& shape) {
  if (count(shape, TopAbs_SOLID) == 0) {
    throw Refused("there is no solid");
  }
}

// That the shapes are edges or faces of the solid: the builders crash on foreign ones.
void belongs(const TopoDS_Shape& shape, const Bundle& parts, TopAbs_ShapeEnum kind) {
  for (const TopoDS_Shape& part : parts.shapes) {
    if (part.ShapeType() != kind || !holds(shape, part)) {
      throw Refused(kind == TopAbs_EDGE ? "an edge is none of the solid's"
                                        : "a face is none of the solid's");
    }
  }
}

// A fillet or chamfer that was set up: asking an unfinished one for its shape is a segmentation
// fault.
template <typename Maker>
SolidPtr dressed(Maker& maker) {
  if (maker.NbContours() == 0) {
    throw Refused("none of the edges can be worked on");
  }
  maker.Build();
  if (!maker.IsDone()) {
    throw Invalid("it does not fit between the neighbouring edges and faces");
  }
  return wrap(maker.Shape());
}

TopoDS_Shape first_shell(const TopoDS_Shape& shape) {
  const std::vector<TopoDS_Shape> shells = distinct(shape, TopAbs_SHELL);
  if (shells.empty()) {
    throw Invalid("nothing closed comes out at this thickness");
  }
  return shells.front();
}

template <typename Maker>
SolidPtr primitive(Maker&& maker) {
  maker.Build();
  if (!maker.IsDone()) {
    throw Invalid("it could not be built");
  }
  return wrap(maker.Solid());
}

}  // namespace

SolidPtr fillet_edges(const Solid& solid, const Bundle& edges, double radius) {
  const TopoDS_Shape& shape = shape_of(solid);
  body(shape);
  belongs(shape, edges, TopAbs_EDGE);
  BRepFilletAPI_MakeFillet maker(shape);
  for (const TopoDS_Shape& edge : edges.shapes) {
    maker.Add(radius, TopoDS::Edge(edge));
  }
  return dressed(maker);
}

// The first length is measured on the face that comes first about each edge.
SolidPtr chamfer_edges(const Solid& solid, const Bundle& edges, double first, double second) {
  const TopoDS_Shape& shape = shape_of(solid);
  body(shape);
  belongs(shape, edges, TopAbs_EDGE);
  TopTools_IndexedDataMapOfShapeListOfShape faces;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces);
  BRepFilletAPI_MakeChamfer maker(shape);
  for (const TopoDS_Shape& edge : edges.shapes) {
    const TopTools_ListOfShape& about = faces.FindFromKey(edge);
    if (about.IsEmpty()) {
      throw Refused("an edge has no face");
    }
    maker.Add(first, second, TopoDS::Edge(edge), TopoDS::Face(about.First()));
  }
  return dressed(maker);
}

SolidPtr hollow(const Solid& solid, const Bundle& open, double thickness, std::uint8_t corner,
                double tolerance) {
  const TopoDS_Shape& shape = shape_of(solid);
  body(shape);
  belongs(shape, open, TopAbs_FACE);
  BRepOffsetAPI_MakeThickSolid maker;
  maker.MakeThickSolidByJoin(shape, list_of(open.shapes), thickness, tolerance, BRepOffset_Skin,
                             Standard_True, Standard_False,
                             corner == 0 ? GeomAbs_Arc : GeomAbs_Intersection);
  if (!maker.IsDone()) {
    throw Invalid("the walls do not fit at this thickness");
  }
  if (!open.shapes.empty()) {
    const double left = integrals(maker.Shape()).volume;
    // Walls that are thicker than the solid leave it as it was, or inside-out; so does a solid of
    // which every face is open.
    if (!(left > 0.0)) {
      throw Invalid("there are no walls");
    }
    const double own = integrals(shape).volume;
    if (thickness < 0.0 && left >= own * (1.0 - 1e-9)) {
      throw Invalid("the walls fill the solid");
    }
    if (std::abs(left - own) <= own * 1e-9 &&
        count(maker.Shape(), TopAbs_FACE) == count(shape, TopAbs_FACE)) {
      throw Invalid("no walls could be made at this thickness");
    }
    return canonical(maker.Shape());
  }
  // Without an open face what came out is the solid moved in or out: the other wall.
  const TopoDS_Shell moved_wall = TopoDS::Shell(first_shell(maker.Shape()));
  const TopoDS_Shell own_wall = TopoDS::Shell(first_shell(shape));
  BRepBuilderAPI_MakeSolid both = thickness > 0.0 ? BRepBuilderAPI_MakeSolid(moved_wall, own_wall)
                                                  : BRepBuilderAPI_MakeSolid(own_wall, moved_wall);
  if (!both.IsDone()) {
    throw Invalid("the two walls make no solid");
  }
  const TopoDS_Shape made = both.Shape();
  if (BRepCheck_Analyzer(made).IsValid()) {
    return canonical(made);
  }
  ShapeFix_Shape fix(made);
  fix.Perform();
  return canonical(fix.Shape());
}

SolidPtr solid_wedge(const At& at, double dx, double dy, double dz, double xmin, double zmin,
                     double xmax, double zmax) {
  return primitive(BRepPrimAPI_MakeWedge(axes(at), dx, dy, dz, xmin, zmin, xmax, zmax));
}

SolidPtr solid_torus(const At& at, double major, double minor) {
  // With the angles spelled out, as CadQuery has them: the seam lies elsewhere without.
  return primitive(BRepPrimAPI_MakeTorus(axes(at), major, minor, 0.0, 2.0 * M_PI));
}

SolidPtr solid_sphere(const At& at, double radius, double low, double high, double turn) {
  return primitive(BRepPrimAPI_MakeSphere(axes(at), radius, low, high, turn));
}

SolidPtr solid_cylinder(const At& at, double radius, double height, double turn) {
  return primitive(BRepPrimAPI_MakeCylinder(axes(at), radius, height, turn));
}

SolidPtr solid_cone(const At& at, double base, double top, double height, double turn) {
  return primitive(BRepPrimAPI_MakeCone(axes(at), base, top, height, turn));
}

}  // namespace assemcad
