#include <BRepBuilderAPI_Transform.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "common.h"

namespace assemcad {

SolidPtr place(const Solid& solid, const Pose& pose) {
  BRepBuilderAPI_Transform maker(shape_of(solid), trsf(pose), Standard_True);
  if (!maker.IsDone()) {
    throw Invalid("it could not be moved");
  }
  return wrap(maker.Shape());
}

bool has_locations(const Solid& solid) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape_of(solid), map);
  for (Standard_Integer i = 1; i <= map.Extent(); ++i) {
    if (!map(i).Location().IsIdentity()) {
      return true;
    }
  }
  return false;
}

}  // namespace assemcad
