// On which side of a solid's surface points lie.
#pragma once

#include <BRepClass3d_SolidClassifier.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Lin.hxx>
#include <gp_Pnt.hxx>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace assemcad {

// What asking for points of one solid needs, made once and kept while the solid is asked about.
//
// A half line from a point leaves the material as often as it enters it, and at its first crossing the
// surface's normal tells the side too. Where both agree, along two lines that nothing speaks against, the
// side is known; everywhere else OCCT's classifier is asked, and so it is for points that may be on the
// surface, except within a plane, cylindrical, conical, spherical or toroidal face.
class Sides {
 public:
  enum Side : std::uint8_t { OUTSIDE = 0, INSIDE = 1, BOUNDARY = 2 };

  explicit Sides(const TopoDS_Shape& solid);
  ~Sides();
  Sides(const Sides&) = delete;
  Sides& operator=(const Sides&) = delete;

  // Points nearer to the surface than `tolerance` are on it.
  Side of(const gp_Pnt& at, double tolerance);

  // Where a round hole from a point along a line, a depth deep, goes through material: lengths from the
  // point, from and to by turns. None where anything but plane faces square to it lies in its way.
  std::optional<std::vector<double>> bores(const gp_Lin& axis, double radius, double depth);

  // The one of a solid that was asked about lately, or a new one.
  static std::shared_ptr<Sides> find(const TopoDS_Shape& solid);

 private:
  struct Wall;
  // What a half line crosses.
  struct Crossings {
    int count = 0;
    double nearest = RealLast();
    bool leaving = false;
  };

  std::optional<Side> touched(const gp_Pnt& at, double tolerance, bool& near) const;
  std::optional<Side> along(const gp_Lin& line, double tolerance) const;
  Side asked(const gp_Pnt& at, double tolerance);

  TopoDS_Shape shape;
  std::vector<std::unique_ptr<Wall>> walls;
  // Whether the faces are such that lines tell anything.
  bool plain = true;
  std::optional<BRepClass3d_SolidClassifier> classifier;
};

}  // namespace assemcad
