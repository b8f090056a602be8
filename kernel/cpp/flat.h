// The outline of a plane face in its plane, and whether points of the plane lie in it. Only for sides.cpp.
#pragma once

#include <TopoDS_Face.hxx>
#include <gp_Ax3.hxx>
#include <gp_XY.hxx>

#include <vector>

namespace assemcad {

// Whether a place lies in a bounded piece of a surface; none where that is too close to tell.
enum class Within { NO, YES, UNSURE };

// A plane face with lines, circles and other curves for edges, taken from the curves in space that
// neighbours share: planes often keep no other, and laying them down anew is what costs.
class Flat {
 public:
  explicit Flat(const TopoDS_Face& face, const gp_Ax3& plane);

  // By crossings of a half line in the plane.
  Within holds(const gp_XY& at) const;
  // How far the nearest edge is at least.
  double clear(const gp_XY& at) const;

 private:
  // A stretch of an edge that goes up or down all the way: straight, or an arc to one side of a circle.
  struct Piece {
    gp_XY from, to, centre;
    // 0 for a straight piece.
    double radius;
    // Which half of the circle: 1 towards +x, -1 towards -x.
    double side;
    // What an approximated edge is off by, at most.
    double off;
  };

  void straight(const gp_XY& from, const gp_XY& to, double off);
  void arc(const gp_XY& centre, double radius, double from, double turn, double off);

  std::vector<Piece> pieces;
};

}  // namespace assemcad
