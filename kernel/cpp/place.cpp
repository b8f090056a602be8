#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "common.h"

namespace assemcad {

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
