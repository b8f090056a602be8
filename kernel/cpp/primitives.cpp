#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>

#include "common.h"

namespace assemcad {

namespace {

template <typename Maker>
SolidPtr built(Maker& maker) {
  maker.Build();
  if (!maker.IsDone()) {
    throw Invalid("it could not be built");
  }
  return wrap(maker.Solid());
}

}  // namespace

SolidPtr make_box(const At& at, double dx, double dy, double dz) {
  BRepPrimAPI_MakeBox maker(axes(at), dx, dy, dz);
  return built(maker);
}

SolidPtr make_cylinder(const At& at, double radius, double height) {
  BRepPrimAPI_MakeCylinder maker(axes(at), radius, height);
  return built(maker);
}

SolidPtr make_cone(const At& at, double base, double top, double height) {
  BRepPrimAPI_MakeCone maker(axes(at), base, top, height);
  return built(maker);
}

SolidPtr make_sphere(const At& at, double radius) {
  BRepPrimAPI_MakeSphere maker(axes(at), radius);
  return built(maker);
}

}  // namespace assemcad
