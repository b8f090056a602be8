#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRep_Builder.hxx>
#include <Geom_Circle.hxx>
#include <ShapeUpgrade_RemoveLocations.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include <cmath>
#include <vector>

#include "common.h"

namespace assemcad {

namespace {

// Kinds of `Piece`.
constexpr std::uint8_t LINE = 0;
constexpr std::uint8_t ARC = 1;
constexpr std::uint8_t CIRCLE = 2;

gp_Pnt on_plane(const gp_Ax2& at, const std::array<double, 2>& p) {
  return at.Location().Translated(gp_Vec(at.XDirection()) * p[0] + gp_Vec(at.YDirection()) * p[1]);
}

TopoDS_Edge circle_edge(const gp_Ax2& at, const Piece& piece) {
  const gp_Ax2 axes(on_plane(at, piece.center),
                    piece.sweep < 0.0 ? at.Direction().Reversed() : at.Direction(),
                    at.XDirection());
  return BRepBuilderAPI_MakeEdge(gp_Circ(axes, piece.radius)).Edge();
}

TopoDS_Edge arc_edge(const gp_Ax2& at, const Piece& piece, const TopoDS_Vertex& from,
                     const TopoDS_Vertex& to) {
  const gp_Pnt center = on_plane(at, piece.center);
  const gp_Dir normal = piece.sweep < 0.0 ? at.Direction().Reversed() : at.Direction();
  const gp_Ax2 axes(center, normal, gp_Dir(gp_Vec(center, on_plane(at, piece.start))));
  const Handle(Geom_Circle) circle = new Geom_Circle(axes, piece.radius);
  BRepBuilderAPI_MakeEdge maker(circle, from, to, 0.0, std::abs(piece.sweep));
  if (!maker.IsDone()) {
    throw Refused("an arc cannot be built");
  }
  return maker.Edge();
}

// The wire of the pieces [begin, end), which are one outline in order.
TopoDS_Wire wire(const gp_Ax2& at, Pieces pieces, std::size_t begin, std::size_t end) {
  BRepBuilderAPI_MakeWire maker;
  if (pieces[begin].kind == CIRCLE) {
    maker.Add(circle_edge(at, pieces[begin]));
  } else {
    // Shared corners, so that the outline is closed by construction and not by tolerance.
    std::vector<TopoDS_Vertex> corners;
    for (std::size_t i = begin; i < end; ++i) {
      corners.push_back(BRepBuilderAPI_MakeVertex(on_plane(at, pieces[i].start)).Vertex());
    }
    for (std::size_t i = begin; i < end; ++i) {
      const TopoDS_Vertex& from = corners[i - begin];
      const TopoDS_Vertex& to = corners[(i - begin + 1) % corners.size()];
      if (pieces[i].kind == ARC) {
        maker.Add(arc_edge(at, pieces[i], from, to));
      } else {
        BRepBuilderAPI_MakeEdge line(from, to);
        if (!line.IsDone()) {
          throw Refused("a line cannot be built");
        }
        maker.Add(line.Edge());
      }
      if (!maker.IsDone()) {
        throw Refused("an outline does not hang together");
      }
    }
  }
  if (!maker.IsDone() || !maker.Wire().Closed()) {
    throw Refused("an outline is not closed");
  }
  return maker.Wire();
}

// The outlines come oriented: the outer one counter-clockwise, holes clockwise.
TopoDS_Face face(const gp_Ax2& at, Pieces pieces) {
  std::vector<TopoDS_Wire> wires;
  for (std::size_t begin = 0; begin < pieces.size();) {
    std::size_t end = begin + 1;
    while (end < pieces.size() && pieces[end].outline == pieces[begin].outline) {
      ++end;
    }
    wires.push_back(wire(at, pieces, begin, end));
    begin = end;
  }
  if (wires.empty()) {
    throw Refused("there is no outline");
  }
  BRepBuilderAPI_MakeFace maker(gp_Pln(gp_Ax3(at)), wires[0], Standard_False);
  for (std::size_t i = 1; i < wires.size() && maker.IsDone(); ++i) {
    maker.Add(wires[i]);
  }
  if (!maker.IsDone()) {
    throw Refused("the outlines bound no region");
  }
  const auto wrong = reasons(maker.Face());
  if (!wrong.empty()) {
    throw Refused(joined(wrong));
  }
  return maker.Face();
}

// A sweep may come out inside-out and with locations; neither may stay.
TopoDS_Shape swept(const TopoDS_Shape& shape) {
  if (shape.IsNull() || shape.ShapeType() != TopAbs_SOLID) {
    throw Invalid("no solid came out");
  }
  ShapeUpgrade_RemoveLocations bake;
  bake.SetRemoveLevel(TopAbs_SHAPE);
  bake.Remove(shape);
  const TopoDS_Shape baked = bake.GetResult();
  if (volume_of(baked) >= 0.0) {
    return baked;
  }
  BRep_Builder builder;
  TopoDS_Solid turned;
  builder.MakeSolid(turned);
  for (TopExp_Explorer it(baked, TopAbs_SHELL); it.More(); it.Next()) {
    builder.Add(turned, it.Current().Reversed());
  }
  return turned;
}

}  // namespace

SolidPtr make_prism(const At& at, Pieces pieces, double length) {
  const gp_Ax2 frame = axes(at);
  BRepPrimAPI_MakePrism maker(face(frame, pieces), gp_Vec(frame.Direction()) * length,
                              Standard_True);
  if (!maker.IsDone()) {
    throw Invalid("it could not be built");
  }
  return wrap(swept(maker.Shape()));
}

SolidPtr make_revolution(const At& at, Pieces pieces, const At& axis, double radians) {
  const gp_Ax1 about(pnt(axis.origin), dir(axis.z));
  const TopoDS_Face region = face(axes(at), pieces);
  // The full turn has its own constructor, which closes the solid onto itself.
  BRepPrimAPI_MakeRevol maker = radians > 0.0
                                    ? BRepPrimAPI_MakeRevol(region, about, radians, Standard_True)
                                    : BRepPrimAPI_MakeRevol(region, about, Standard_True);
  if (!maker.IsDone()) {
    throw Invalid("it could not be built");
  }
  return wrap(swept(maker.Shape()));
}

}  // namespace assemcad
