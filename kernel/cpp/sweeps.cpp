#include <Approx_ParametrizationType.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepFeat_MakeDPrism.hxx>
#include <BRepIntCurveSurface_Inter.hxx>
#include <BRepLib_FindSurface.hxx>
#include <BRepOffsetAPI_MakePipeShell.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRep_Tool.hxx>
#include <LocOpe_DPrism.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <gp_Lin.hxx>
#include <gp_Pln.hxx>

#include <algorithm>
#include <cmath>

#include "brep_common.h"

namespace assemcad {

namespace {

void no_solids(const TopoDS_Shape& shape) {
  if (shape.ShapeType() < TopAbs_SHELL && count(shape, TopAbs_SOLID) > 0) {
    throw Refused("a solid cannot be swept");
  }
  if (direct(shape).empty() && shape.ShapeType() != TopAbs_VERTEX) {
    throw Refused("there is nothing in the profile");
  }
}

// What the pipe builder made, or the plain reason why there is nothing.
TopoDS_Shape finished(BRepOffsetAPI_MakePipeShell& maker, bool solid) {
  if (!maker.IsReady()) {
    throw Refused("the sweep has no profile");
  }
  maker.Build();
  if (!maker.IsDone()) {
    switch (maker.GetStatus()) {
      case BRepBuilderAPI_PlaneNotIntersectGuide:
        throw Invalid("the guide does not reach across the whole path");
      case BRepBuilderAPI_ImpossibleContact:
        throw Invalid("the profile cannot follow the guide");
      default:
        throw Invalid("the profile cannot be carried along the path");
    }
  }
  if (solid) {
    // Where the profile is open this does nothing, and the sheet is what there is.
    maker.MakeSolid();
  }
  return maker.Shape();
}

// The law that turns the profile along the path. True where the profile has to be turned to it.
bool oriented(BRepOffsetAPI_MakePipeShell& maker, const TopoDS_Shape& path, const Bundle& guide,
              Reals normal, bool frenet) {
  if (normal.size() == 3) {
    gp_Ax2 axes;
    axes.SetLocation(end_of(path, false));
    axes.SetDirection(gp_Dir(normal[0], normal[1], normal[2]));
    maker.SetMode(axes);
    return true;
  }
  if (!guide.shapes.empty()) {
    maker.SetMode(wire_in(guide.shapes.front()), Standard_True);
  } else {
    maker.SetMode(frenet);
  }
  return false;
}

TopoDS_Wire border(const TopoDS_Shape& section) {
  return section.ShapeType() == TopAbs_FACE ? outer_of(TopoDS::Face(section)) : wire_in(section);
}

TopoDS_Shape without_all(const TopoDS_Shape& from, const std::vector<TopoDS_Shape>& tools) {
  BRepAlgoAPI_Cut cut;
  cut.SetArguments(list_of({from}));
  cut.SetTools(list_of(tools));
  cut.SetNonDestructive(Standard_True);
  cut.SetRunParallel(Standard_False);
  cut.Build();
  if (cut.HasErrors() || !cut.IsDone()) {
    throw Invalid("the holes could not be taken out");
  }
  return cut.Shape();
}

TopoDS_Shape swept_wire(const TopoDS_Wire& wire, const TopoDS_Shape& path, const Bundle& guide,
                        Reals normal, bool frenet, bool solid, std::uint8_t transition) {
  // Rounding the corners of a path in the plane of the profile is a segmentation fault, and what
  // other corners make of it has no volume.
  if ((transition == 1 || BRep_Tool::IsClosed(wire)) &&
      BRepLib_FindSurface(compound_from({wire, path}), -1.0, Standard_True).Found()) {
    throw Refused("the path lies in the plane of the profile");
  }
  BRepOffsetAPI_MakePipeShell maker(wire_in(path));
  const bool turned = oriented(maker, path, guide, normal, frenet);
  maker.SetTransitionMode(transition == 0   ? BRepBuilderAPI_Transformed
                          : transition == 1 ? BRepBuilderAPI_RoundCorner
                                            : BRepBuilderAPI_RightCorner);
  maker.Add(wire, Standard_False, turned);
  return finished(maker, solid);
}

TopoDS_Shape twisted_wire(const TopoDS_Wire& wire, const TopoDS_Wire& spine,
                          const TopoDS_Wire& guide) {
  BRepOffsetAPI_MakePipeShell maker(spine);
  maker.SetMode(guide, Standard_False);
  maker.Add(wire);
  return finished(maker, true);
}

}  // namespace

SolidPtr extrude(const Solid& profile, const Vector& vector) {
  const TopoDS_Shape& shape = shape_of(profile);
  no_solids(shape);
  BRepPrimAPI_MakePrism maker(shape, gp_Vec(vector[0], vector[1], vector[2]), Standard_True);
  if (!maker.IsDone()) {
    throw Invalid("it could not be built");
  }
  return wrap(maker.Shape());
}

// `slant` is how far the sides reach along themselves, both with the sign of the face's normal.
SolidPtr extrude_tapered(const Solid& face, double slant, double taper) {
  if (BRepAdaptor_Surface(face_in(shape_of(face)), Standard_False).GetType() != GeomAbs_Plane) {
    throw Refused("the face is not flat");
  }
  const LocOpe_DPrism maker(face_in(shape_of(face)), slant, taper);
  if (!maker.IsDone() || maker.Shape().IsNull() || count(maker.Shape(), TopAbs_SOLID) == 0) {
    throw Invalid("its sides cannot be slanted so much over this length");
  }
  // Where the sides meet before, it ends there without a word.
  const double height = std::abs(slant) * std::cos(taper);
  const gp_Pln base = BRepAdaptor_Surface(face_in(shape_of(face)), Standard_False).Plane();
  double reached = 0.0;
  for (const TopoDS_Shape& corner : distinct(maker.Shape(), TopAbs_VERTEX)) {
    reached = std::max(reached, base.Distance(BRep_Tool::Pnt(TopoDS::Vertex(corner))));
  }
  if (reached < height * (1.0 - 1e-6)) {
    throw Refused("its sides meet before its end");
  }
  return canonical(maker.Shape());
}

namespace {

// A tapered prism through all of a solid, to both sides of its face: narrower along the normal, wider
// against it. OCCT's own two-sided one comes out with its planes either way round, and ends short of the
// far side by the cosine of the taper.
TopoDS_Shape tapered_through(const TopoDS_Shape& body, const TopoDS_Face& face, double taper,
                             bool additive) {
  BRepAdaptor_Surface flat(face, Standard_False);
  if (flat.GetType() != GeomAbs_Plane) {
    throw Refused("the face is not flat");
  }
  const gp_Pln plane = flat.Plane();
  gp_Dir normal = plane.Position().Direct() ? plane.Axis().Direction()
                                            : plane.Axis().Direction().Reversed();
  if (face.Orientation() == TopAbs_REVERSED) {
    normal.Reverse();
  }
  const Bnd_Box box = tight_box(body);
  const gp_Pnt low = box.CornerMin();
  const gp_Pnt high = box.CornerMax();
  double ahead = 0.0;
  double behind = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const gp_Pnt p((corner & 1) != 0 ? high.X() : low.X(), (corner & 2) != 0 ? high.Y() : low.Y(),
                   (corner & 4) != 0 ? high.Z() : low.Z());
    const double height = gp_Vec(plane.Location(), p).Dot(gp_Vec(normal));
    ahead = std::max(ahead, height);
    behind = std::max(behind, -height);
  }
  // What is taken away reaches a little past the solid.
  const double past = additive ? 0.0 : 0.1 * (ahead + behind);
  std::vector<TopoDS_Shape> tools;
  for (const double height : {ahead, -behind}) {
    if (std::abs(height) > Precision::Confusion()) {
      const double slant = (height + std::copysign(past, height)) / std::cos(taper);
      const LocOpe_DPrism maker(face, slant, taper);
      if (!maker.IsDone() || maker.Shape().IsNull() || count(maker.Shape(), TopAbs_SOLID) == 0) {
        throw Invalid("its sides cannot be slanted so much over this length");
      }
      tools.push_back(canonical(maker.Shape())->shape);
    }
  }
  if (tools.empty()) {
    throw Invalid("the profile does not meet the solid");
  }
  Bundle bundle;
  bundle.shapes = tools;
  const SolidPtr whole = wrap(body);
  const TopoDS_Shape made = (additive ? fuse_all(*whole, bundle, false, 0.0)
                                      : cut_all(*whole, bundle, 0.0))->shape;
  const std::vector<TopoDS_Shape> parts = direct(made);
  return made.ShapeType() == TopAbs_COMPOUND && parts.size() == 1 ? parts.front() : made;
}

}  // namespace

SolidPtr extrude_until(const Solid& basis, const Solid& face, const Bundle& up_to, double taper,
                       bool additive) {
  const TopoDS_Shape& body = shape_of(basis);
  if (count(body, TopAbs_SOLID) == 0) {
    throw Refused("there is no solid to build on");
  }
  if (up_to.shapes.empty() && taper != 0.0) {
    return wrap(tapered_through(body, face_in(shape_of(face)), taper, additive));
  }
  BRepFeat_MakeDPrism maker(body, face_in(shape_of(face)), TopoDS_Face(), taper,
                            additive ? 1 : 0, Standard_False);
  if (up_to.shapes.empty()) {
    maker.PerformThruAll();
  } else {
    maker.Perform(up_to.shapes.front());
  }
  if (!maker.IsDone()) {
    throw Invalid("the profile does not meet what it shall end at, or leaves the solid");
  }
  return taper == 0.0 ? wrap(maker.Shape()) : canonical(maker.Shape());
}

// Sides: 0 ahead, 1 behind, 2 both.
BundlePtr faces_on_line(const Solid& shape, const Vector& point, const Vector& direction,
                        std::uint8_t side, double tolerance) {
  const gp_Pnt from = pnt(point);
  const gp_Dir along = dir(direction);
  BRepIntCurveSurface_Inter crossing;
  struct Hit {
    TopoDS_Shape face;
    double square;
  };
  std::vector<Hit> hits;
  for (crossing.Init(shape_of(shape), gp_Lin(from, along), tolerance); crossing.More();
       crossing.Next()) {
    const double square = from.SquareDistance(crossing.Pnt());
    if (side != 2) {
      // The face on which the point lies is on neither side. The square is compared as CadQuery does.
      if (!(from.Distance(crossing.Pnt()) > gp::Resolution()) || !(square > tolerance)) {
        continue;
      }
      const bool behind = gp_Dir(gp_Vec(from, crossing.Pnt())).IsOpposite(along, tolerance);
      if (behind != (side == 1)) {
        continue;
      }
    }
    hits.push_back({crossing.Face(), square});
  }
  std::stable_sort(hits.begin(), hits.end(),
                   [](const Hit& a, const Hit& b) { return a.square < b.square; });
  BundlePtr out = bundle();
  for (const Hit& hit : hits) {
    out->shapes.push_back(hit.face);
  }
  return out;
}

// A helix beside the straight path tells how the profile turns: `radians` over the whole length.
SolidPtr extrude_twisted(const Solid& face, const Vector& center, const Vector& vector,
                         double radians) {
  const TopoDS_Face profile = face_in(shape_of(face));
  const gp_Pnt from = pnt(center);
  const gp_Vec along(vector[0], vector[1], vector[2]);
  const double height = along.Magnitude();
  const TopoDS_Wire spine =
      wire_in(BRepBuilderAPI_MakeEdge(from, from.Translated(along)).Edge());
  const TopoDS_Wire guide = helix(2.0 * M_PI / radians * height, height, 1.0,
                                  gp_Ax3(from, gp_Dir(along)), 0.0, false);
  const TopoDS_Shape outer = twisted_wire(outer_of(profile), spine, guide);
  std::vector<TopoDS_Shape> holes;
  for (const TopoDS_Shape& wire : inner_of(profile)) {
    holes.push_back(twisted_wire(TopoDS::Wire(wire), spine, guide));
  }
  return wrap(holes.empty() ? compound_from({outer}) : without_all(outer, holes));
}

SolidPtr turn_about(const Solid& profile, const Vector& from, const Vector& direction,
                    double radians) {
  const TopoDS_Shape& shape = shape_of(profile);
  no_solids(shape);
  BRepPrimAPI_MakeRevol maker(shape, gp_Ax1(pnt(from), dir(direction)), radians, Standard_True);
  if (!maker.IsDone()) {
    throw Invalid("it could not be built");
  }
  return wrap(maker.Shape());
}

SolidPtr sweep(const Solid& profile, const Solid& path, const Bundle& guide, Reals normal,
               bool frenet, bool solid, std::uint8_t transition) {
  const TopoDS_Shape& section = shape_of(profile);
  const auto one = [&](const TopoDS_Shape& wire) {
    return swept_wire(TopoDS::Wire(wire), shape_of(path), guide, normal, frenet, solid,
                      transition);
  };
  const TopoDS_Shape outer = one(border(section));
  std::vector<TopoDS_Shape> holes;
  if (section.ShapeType() == TopAbs_FACE) {
    for (const TopoDS_Shape& wire : inner_of(TopoDS::Face(section))) {
      holes.push_back(one(wire));
    }
  }
  return wrap(holes.empty() ? outer : without_all(outer, holes));
}

SolidPtr sweep_multi(const Bundle& sections, const Solid& path, const Bundle& guide, Reals normal,
                     bool frenet, bool solid) {
  const TopoDS_Shape& along = shape_of(path);
  BRepOffsetAPI_MakePipeShell maker(wire_in(along));
  const bool turned = oriented(maker, along, guide, normal, frenet);
  for (const TopoDS_Shape& section : sections.shapes) {
    maker.Add(border(section), Standard_False, turned);
  }
  return wrap(finished(maker, solid));
}

// Sections are wires, or vertices at the ends. Degree, continuity and parametrization are those of
// CadQuery's loft.
SolidPtr loft(const Bundle& sections, bool ruled, bool solid) {
  BRepOffsetAPI_ThruSections maker(solid, ruled);
  maker.SetMaxDegree(3);
  maker.SetContinuity(GeomAbs_C2);
  maker.SetParType(Approx_IsoParametric);
  bool known = false;
  bool closed = false;
  TopoDS_Shape last;
  for (const TopoDS_Shape& section : sections.shapes) {
    if (section.ShapeType() == TopAbs_VERTEX) {
      maker.AddVertex(TopoDS::Vertex(section));
      continue;
    }
    const TopoDS_Wire wire = border(section);
    // Open sections among closed ones end in a segmentation fault.
    if (known && BRep_Tool::IsClosed(wire) != closed) {
      throw Refused("some of the outlines are closed and some are open");
    }
    if (known && section.IsSame(last)) {
      throw Refused("an outline follows itself");
    }
    last = section;
    known = true;
    closed = BRep_Tool::IsClosed(wire);
    if (solid && !closed) {
      throw Refused("an outline is open, and a solid is asked for");
    }
    maker.AddWire(wire);
  }
  if (!known) {
    throw Refused("a loft needs an outline, and all its sections are points");
  }
  maker.Build();
  if (!maker.IsDone()) {
    throw Invalid("the outlines cannot be joined");
  }
  return wrap(maker.Shape());
}

}  // namespace assemcad
