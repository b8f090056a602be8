#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "common.h"

namespace assemcad {

namespace {

// Indices count from 0 in the order of TopExp::MapShapes, as `edges` reports them.
template <typename Maker>
SolidPtr dressed(Maker& maker, const TopoDS_Shape& shape, Indices edges, double size) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, TopAbs_EDGE, map);
  for (const std::uint32_t edge : edges) {
    if (edge >= static_cast<std::uint32_t>(map.Extent())) {
      throw Refused("there is no edge of this number");
    }
    maker.Add(size, TopoDS::Edge(map(static_cast<Standard_Integer>(edge) + 1)));
  }
  if (maker.NbContours() == 0) {
    throw Refused("none of the edges can be worked on");
  }
  maker.Build();
  // Asking an unfinished fillet for its shape is a segmentation fault.
  if (!maker.IsDone()) {
    throw Invalid("it does not fit between the neighbouring edges and faces");
  }
  return wrap(maker.Shape());
}

}  // namespace

SolidPtr fillet(const Solid& solid, Indices edges, double radius) {
  BRepFilletAPI_MakeFillet maker(shape_of(solid));
  return dressed(maker, solid.shape, edges, radius);
}

SolidPtr chamfer(const Solid& solid, Indices edges, double distance) {
  BRepFilletAPI_MakeChamfer maker(shape_of(solid));
  return dressed(maker, solid.shape, edges, distance);
}

}  // namespace assemcad
