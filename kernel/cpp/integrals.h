// Volume, area, centres and inertia; only for the .cpp files.
#pragma once

#include <TopoDS_Shape.hxx>
#include <gp_Mat.hxx>
#include <gp_Pnt.hxx>

namespace assemcad {

struct Integrals {
  // Of the solids; where there are none, what the faces would enclose.
  double volume = 0.0;
  gp_Pnt center;
  // About the centre, at density 1.
  gp_Mat inertia;
  // Of all faces; one that two solids share counts for each.
  double area = 0.0;
  gp_Pnt area_center;
};

// Invalid where they do not settle to 1e-9, or a face lacks what bounds it.
Integrals integrals(const TopoDS_Shape& shape);

}  // namespace assemcad
