// One order for shapes that come out in another order in every process.
//
// Some algorithms walk maps that are hashed by addresses. What they make is the same body, but its
// faces, wires, edges and the curves of one edge follow one another in any order, and straight edges run
// either way. Here everything is built anew in an order that geometry alone decides; no location stays on
// anything. Without the ordering the same takes locations off a shape.
#include <BRepAdaptor_Curve.hxx>
#include <BRepClass3d.hxx>
#include <BRepTools.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_CurveOn2Surfaces.hxx>
#include <BRep_CurveOnClosedSurface.hxx>
#include <BRep_CurveOnSurface.hxx>
#include <BRep_Curve3D.hxx>
#include <BRep_ListOfCurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_TFace.hxx>
#include <BRep_TVertex.hxx>
#include <BRep_Tool.hxx>
#include <BinTools_Curve2dSet.hxx>
#include <BinTools_CurveSet.hxx>
#include <BinTools_OStream.hxx>
#include <BinTools_SurfaceSet.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_Line.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopExp.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "brep_common.h"

namespace assemcad {

namespace {

// A place on a grid of 1e-6 mm: what differs in the last digits only has one place.
using Place = std::array<std::int64_t, 3>;

Place place_of(const gp_Pnt& p) {
  const auto on_grid = [](double x) { return static_cast<std::int64_t>(std::llround(x * 1e6)); };
  return {on_grid(p.X()), on_grid(p.Y()), on_grid(p.Z())};
}

struct Key {
  Place place{};
  std::string content;

  bool operator<(const Key& other) const {
    return place != other.place ? place < other.place : content < other.content;
  }
  bool operator==(const Key& other) const {
    return place == other.place && content == other.content;
  }
};

// Numbers as bytes, in any order that is always the same.
template <typename T>
void put(std::string& out, T value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

// Adding 0.0 turns -0.0 into 0.0.
void put(std::string& out, double value) {
  value += 0.0;
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <typename Write>
std::string written(Write&& write) {
  std::ostringstream stream(std::ios::binary);
  {
    BinTools_OStream out(stream);
    write(out);
  }
  return stream.str();
}

std::string bytes_of(const Handle(Geom_Surface)& surface) {
  return written([&](BinTools_OStream& out) { BinTools_SurfaceSet::WriteSurface(surface, out); });
}

std::string bytes_of(const Handle(Geom_Curve)& curve) {
  return written([&](BinTools_OStream& out) { BinTools_CurveSet::WriteCurve(curve, out); });
}

std::string bytes_of(const Handle(Geom2d_Curve)& curve) {
  return written([&](BinTools_OStream& out) { BinTools_Curve2dSet::WriteCurve2d(curve, out); });
}

// The line that a curve is, trimmed or not: an edge has its own range. Null for other curves.
Handle(Geom_Line) line_of(Handle(Geom_Curve) curve) {
  while (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve)) {
    curve = trimmed->BasisCurve();
  }
  return Handle(Geom_Line)::DownCast(curve);
}

Handle(Geom2d_Line) line_of(Handle(Geom2d_Curve) curve) {
  while (const auto trimmed = Handle(Geom2d_TrimmedCurve)::DownCast(curve)) {
    curve = trimmed->BasisCurve();
  }
  return Handle(Geom2d_Line)::DownCast(curve);
}

// A line again, with no -0.0 in it, or the other way round.
Handle(Geom_Line) line_again(const Handle(Geom_Line)& line, bool turned) {
  const double sign = turned ? -1.0 : 1.0;
  const gp_Pnt at = line->Position().Location();
  const gp_Dir d = line->Position().Direction();
  return new Geom_Line(
      gp_Pnt(at.X() + 0.0, at.Y() + 0.0, at.Z() + 0.0),
      gp_Dir(sign * d.X() + 0.0, sign * d.Y() + 0.0, sign * d.Z() + 0.0));
}

Handle(Geom2d_Line) line_again(const Handle(Geom2d_Line)& line, bool turned) {
  const double sign = turned ? -1.0 : 1.0;
  const gp_Pnt2d at = line->Position().Location();
  const gp_Dir2d d = line->Position().Direction();
  return new Geom2d_Line(gp_Pnt2d(at.X() + 0.0, at.Y() + 0.0),
                         gp_Dir2d(sign * d.X() + 0.0, sign * d.Y() + 0.0));
}

class Canon {
 public:
  Canon(const TopoDS_Shape& root, bool ordered) : root_(root), ordered_(ordered) {
    TopExp::MapShapesAndAncestors(root, TopAbs_EDGE, TopAbs_FACE, faces_of_);
    TopExp::MapShapesAndAncestors(root, TopAbs_WIRE, TopAbs_FACE, face_of_wire_);
  }

  TopoDS_Shape perform() {
    all(TopAbs_VERTEX, [this](const TopoDS_Shape& s) { return vertex(TopoDS::Vertex(s)); });
    all(TopAbs_EDGE, [this](const TopoDS_Shape& s) { return edge(TopoDS::Edge(s)); });
    all(TopAbs_WIRE, [this](const TopoDS_Shape& s) { return wire(TopoDS::Wire(s)); });
    all(TopAbs_FACE, [this](const TopoDS_Shape& s) { return face(TopoDS::Face(s)); });
    const auto grouped = [this](const TopoDS_Shape& s) { return group(s); };
    for (const TopAbs_ShapeEnum kind : {TopAbs_SHELL, TopAbs_SOLID, TopAbs_COMPSOLID}) {
      all(kind, grouped);
    }
    // Groups may hold groups: the inner ones first.
    TopTools_IndexedMapOfShape everything;
    TopExp::MapShapes(root_, everything);
    std::vector<TopoDS_Shape> left;
    for (Standard_Integer i = 1; i <= everything.Extent(); ++i) {
      if (everything(i).ShapeType() == TopAbs_COMPOUND) {
        left.push_back(everything(i));
      }
    }
    while (!left.empty()) {
      const auto waits = std::stable_partition(
          left.begin(), left.end(), [this](const TopoDS_Shape& s) { return complete(s); });
      if (waits == left.begin()) {
        throw Invalid("a group holds what was not built");
      }
      all(std::vector<TopoDS_Shape>(left.begin(), waits), grouped);
      left.erase(left.begin(), waits);
    }
    return made(root_);
  }

 private:
  // What was built for a shape, and what it is sorted by.
  struct Built {
    Key key;
    TopoDS_Shape shape;
    bool turned = false;
  };

  // Whether all children have been built.
  bool complete(const TopoDS_Shape& shape) const {
    const std::vector<TopoDS_Shape> children = direct(shape);
    return std::all_of(children.begin(), children.end(),
                       [this](const TopoDS_Shape& child) { return made_.IsBound(child); });
  }

  template <typename Build>
  void all(TopAbs_ShapeEnum kind, Build&& build) {
    all(distinct(root_, kind), build);
  }

  // Builds shapes of one kind and numbers them in their order.
  template <typename Build>
  void all(const std::vector<TopoDS_Shape>& shapes, Build&& build) {
    std::vector<std::pair<TopoDS_Shape, Built>> found;
    for (const TopoDS_Shape& shape : shapes) {
      const TopoDS_Shape forward = shape.Oriented(TopAbs_FORWARD);
      found.emplace_back(forward, build(forward));
    }
    if (ordered_) {
      std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
        return a.second.key < b.second.key;
      });
    }
    const Key* last = nullptr;
    for (const auto& [shape, built] : found) {
      // What has one key has one rank.
      if (!ordered_ || last == nullptr || !(*last == built.key)) {
        ++rank_;
      }
      last = &built.key;
      made_.Bind(shape, built.shape);
      ranks_.Bind(shape, rank_);
      places_[rank_] = built.key.place;
      if (built.turned) {
        turned_.Bind(shape, 1);
      }
    }
  }

  // What was built, the way round that the old shape is.
  TopoDS_Shape made(const TopoDS_Shape& old) const {
    const TopoDS_Shape& shape = made_.Find(old);
    return shape.Oriented(orientation(old));
  }

  TopAbs_Orientation orientation(const TopoDS_Shape& old) const {
    return turned_.IsBound(old) ? TopAbs::Reverse(old.Orientation()) : old.Orientation();
  }

  int rank(const TopoDS_Shape& old) const { return ranks_.Find(old); }

  // The way round first for edges: a seam comes twice.
  bool before(const TopoDS_Shape& a, const TopoDS_Shape& b) const {
    const int i = rank(a);
    const int j = rank(b);
    return i != j ? i < j : orientation(a) < orientation(b);
  }

  std::vector<TopoDS_Shape> sorted(const TopoDS_Shape& of) const {
    std::vector<TopoDS_Shape> out = direct(of);
    if (!ordered_) {
      return out;
    }
    std::stable_sort(out.begin(), out.end(), [this](const TopoDS_Shape& a, const TopoDS_Shape& b) {
      return before(a, b);
    });
    return out;
  }

  // The key of what is made of other shapes: the middle of their places, and which they are.
  Key key_of(const std::vector<TopoDS_Shape>& children) const {
    Key key;
    for (const TopoDS_Shape& child : children) {
      const Place& place = places_.at(rank(child));
      for (std::size_t i = 0; i < 3; ++i) {
        key.place[i] += place[i];
      }
      put(key.content, rank(child));
      put(key.content, static_cast<int>(orientation(child)));
    }
    for (std::int64_t& x : key.place) {
      x /= static_cast<std::int64_t>(std::max<std::size_t>(children.size(), 1));
    }
    return key;
  }

  static void flags(const TopoDS_Shape& from, TopoDS_Shape& to) {
    to.Closed(from.Closed());
    to.Infinite(from.Infinite());
    to.Convex(from.Convex());
    to.Orientable(from.Orientable());
  }

  static Built vertex(const TopoDS_Vertex& old) {
    const gp_Pnt p = BRep_Tool::Pnt(old);
    const gp_Pnt at(p.X() + 0.0, p.Y() + 0.0, p.Z() + 0.0);
    TopoDS_Vertex out;
    BRep_Builder().MakeVertex(out, at, BRep_Tool::Tolerance(old));
    Built built;
    built.key.place = place_of(at);
    for (const double x : {at.X(), at.Y(), at.Z(), BRep_Tool::Tolerance(old)}) {
      put(built.key.content, x);
    }
    flags(old, out);
    built.shape = out;
    return built;
  }

  // A surface where it is, without a location; one and the same for faces that share it.
  Handle(Geom_Surface) standing(const Handle(Geom_Surface)& surface, const TopLoc_Location& at) {
    if (surface.IsNull() || at.IsIdentity()) {
      return surface;
    }
    for (const Moved& known : moved_) {
      if (known.from == surface && known.at == at) {
        return known.to;
      }
    }
    const Handle(Geom_Surface) to =
        Handle(Geom_Surface)::DownCast(surface->Transformed(at.Transformation()));
    moved_.push_back({surface, at, to});
    return to;
  }

  // The surface of one of the faces of the edge that a curve of it says it lies on; none where it is
  // left over from an algorithm.
  Handle(Geom_Surface) under(const TopoDS_Edge& edge, const Handle(Geom_Surface)& surface,
                             const TopLoc_Location& at) {
    if (!faces_of_.Contains(edge)) {
      return standing(surface, edge.Location() * at);
    }
    for (const TopoDS_Shape& face : faces_of_.FindFromKey(edge)) {
      TopLoc_Location location;
      const Handle(Geom_Surface)& own = BRep_Tool::Surface(TopoDS::Face(face), location);
      if (own == surface && location.Predivided(edge.Location()) == at) {
        return standing(own, location);
      }
    }
    return nullptr;
  }

  // Whether an edge is straight in space and on all of its faces.
  static bool straight(const BRep_ListOfCurveRepresentation& list) {
    bool line = false;
    for (const Handle(BRep_CurveRepresentation)& rep : list) {
      if (rep->IsCurve3D()) {
        line = !line_of(rep->Curve3D()).IsNull();
      } else if (rep->IsCurveOnSurface()) {
        if (line_of(rep->PCurve()).IsNull() ||
            (rep->IsCurveOnClosedSurface() && line_of(rep->PCurve2()).IsNull())) {
          return false;
        }
      }
    }
    return line;
  }

  // A curve of an edge again, without a location; straight ones run the canonical way. None where it
  // lies on no face of the edge.
  Handle(BRep_CurveRepresentation) again(const TopoDS_Edge& edge,
                                         const Handle(BRep_CurveRepresentation)& rep, bool line,
                                         bool turned) {
    const TopLoc_Location none;
    if (rep->IsRegularity() && !rep->IsCurveOnSurface()) {
      const Handle(Geom_Surface) one = under(edge, rep->Surface(), rep->Location());
      const Handle(Geom_Surface) other = under(edge, rep->Surface2(), rep->Location2());
      if (one.IsNull() || other.IsNull()) {
        return nullptr;
      }
      const bool swapped = ordered_ && bytes_of(other) < bytes_of(one);
      return new BRep_CurveOn2Surfaces(swapped ? other : one, swapped ? one : other, none, none,
                                       rep->Continuity());
    }
    const Handle(BRep_GCurve) from = Handle(BRep_GCurve)::DownCast(rep);
    Handle(BRep_GCurve) out;
    if (rep->IsCurve3D()) {
      Handle(Geom_Curve) curve = rep->Curve3D();
      const TopLoc_Location at = edge.Location() * rep->Location();
      if (!curve.IsNull() && !at.IsIdentity()) {
        curve = Handle(Geom_Curve)::DownCast(curve->Transformed(at.Transformation()));
      }
      if (line) {
        curve = line_again(line_of(curve), turned);
      }
      out = new BRep_Curve3D(curve, none);
    } else if (rep->IsCurveOnSurface()) {
      const Handle(Geom_Surface) surface = under(edge, rep->Surface(), rep->Location());
      if (surface.IsNull()) {
        return nullptr;
      }
      const auto on = [&](const Handle(Geom2d_Curve)& curve) {
        return line ? Handle(Geom2d_Curve)(line_again(line_of(curve), turned))
                    : curve;
      };
      const Handle(Geom2d_Curve) one = on(rep->PCurve());
      if (rep->IsCurveOnClosedSurface()) {
        const Handle(Geom2d_Curve) other = on(rep->PCurve2());
        out = new BRep_CurveOnClosedSurface(turned ? other : one, turned ? one : other, surface, none,
                                            rep->Continuity());
      } else {
        out = new BRep_CurveOnSurface(one, surface, none);
      }
    } else {
      return nullptr;
    }
    if (turned) {
      out->SetRange(-from->Last() + 0.0, -from->First() + 0.0);
    } else {
      out->SetRange(from->First() + 0.0, from->Last() + 0.0);
    }
    return out;
  }

  static std::string bytes_of_rep(const Handle(BRep_CurveRepresentation)& rep) {
    std::string out;
    put(out, rep->IsCurve3D() ? 0 : rep->IsCurveOnSurface() ? 1 : 2);
    const Handle(BRep_GCurve) curve = Handle(BRep_GCurve)::DownCast(rep);
    if (rep->IsCurve3D()) {
      out += rep->Curve3D().IsNull() ? "" : bytes_of(rep->Curve3D());
    } else {
      out += bytes_of(rep->Surface());
      if (rep->IsCurveOnSurface()) {
        out += bytes_of(rep->PCurve());
      }
      if (rep->IsCurveOnClosedSurface()) {
        out += bytes_of(rep->PCurve2());
      }
      if (rep->IsRegularity()) {
        out += bytes_of(rep->Surface2());
        put(out, static_cast<int>(rep->Continuity()));
      }
    }
    if (!curve.IsNull()) {
      put(out, curve->First());
      put(out, curve->Last());
    }
    return out;
  }

  Built edge(const TopoDS_Edge& old) {
    const Handle(BRep_TEdge) from = Handle(BRep_TEdge)::DownCast(old.TShape());
    Built built;
    const bool line = ordered_ && straight(from->Curves());
    double first = 0.0;
    double last = 0.0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(old, first, last);
    const bool bounded = !curve.IsNull() && std::abs(first) < 1e50 && std::abs(last) < 1e50;
    if (line && bounded) {
      built.turned = place_of(curve->Value(last)) < place_of(curve->Value(first));
    }

    const Handle(BRep_TEdge) to = new BRep_TEdge;
    to->Tolerance(from->Tolerance());
    to->SameParameter(from->SameParameter());
    to->SameRange(from->SameRange());
    to->Degenerated(from->Degenerated());
    std::vector<std::pair<std::string, Handle(BRep_CurveRepresentation)>> reps;
    for (const Handle(BRep_CurveRepresentation)& rep : from->Curves()) {
      const Handle(BRep_CurveRepresentation) copy = again(old, rep, line, built.turned);
      if (!copy.IsNull()) {
        reps.emplace_back(ordered_ ? bytes_of_rep(copy) : std::string(), copy);
      }
    }
    std::stable_sort(reps.begin(), reps.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });

    std::vector<TopoDS_Shape> ends = direct(old);
    // Straight edges may be turned: the vertex at the start is then the one that was at the end.
    const auto way = [&](const TopoDS_Shape& v) {
      return built.turned ? TopAbs::Reverse(v.Orientation()) : v.Orientation();
    };
    if (ordered_) {
    std::stable_sort(ends.begin(), ends.end(), [&](const TopoDS_Shape& a, const TopoDS_Shape& b) {
      return way(a) != way(b) ? way(a) < way(b) : rank(a) < rank(b);
    });
    }
    built.key = key_of(ends);
    for (const TopoDS_Shape& end : ends) {
      put(built.key.content, static_cast<int>(way(end)));
    }
    if (bounded && !from->Degenerated()) {
      built.key.place = place_of(curve->Value(0.5 * (first + last)));
    }
    put(built.key.content, from->Tolerance());
    for (const auto& [bytes, rep] : reps) {
      built.key.content += bytes;
      to->ChangeCurves().Append(rep);
    }

    TopoDS_Edge out;
    out.TShape(to);
    BRep_Builder builder;
    for (const TopoDS_Shape& end : ends) {
      builder.Add(out, made_.Find(end).Oriented(way(end)));
    }
    flags(old, out);
    built.shape = out;
    return built;
  }

  // The edges of a wire one after the other, from the first one in order.
  std::vector<TopoDS_Shape> walked(const TopoDS_Wire& old,
                                   const std::vector<TopoDS_Shape>& children) const {
    BRep_Builder builder;
    TopoDS_Wire loose;
    builder.MakeWire(loose);
    for (const TopoDS_Shape& child : children) {
      builder.Add(loose, child);
    }
    loose.Closed(old.Closed());
    std::vector<TopoDS_Shape> walk;
    TopoDS_Face face;
    if (face_of_wire_.Contains(old)) {
      face = TopoDS::Face(face_of_wire_.FindFromKey(old).First().Oriented(TopAbs_FORWARD));
    }
    BRepTools_WireExplorer it;
    face.IsNull() ? it.Init(loose) : it.Init(loose, face);
    for (; it.More() && walk.size() <= children.size(); it.Next()) {
      walk.push_back(it.Current());
    }
    if (walk.size() != children.size()) {
      return children;
    }
    return walk;
  }

  Built wire(const TopoDS_Wire& old) const {
    const std::vector<TopoDS_Shape> children = sorted(old);
    BRep_Builder builder;
    std::vector<TopoDS_Shape> walk = children;
    if (ordered_) {
      walk = walked(old, children);
    }
    Built built;
    built.key = key_of(children);
    TopoDS_Wire out;
    builder.MakeWire(out);
    for (const TopoDS_Shape& child : walk) {
      builder.Add(out, made(child));
    }
    flags(old, out);
    built.shape = out;
    return built;
  }

  Built face(const TopoDS_Face& old) {
    std::vector<TopoDS_Shape> children = sorted(old);
    Built built;
    built.key = key_of(children);
    TopLoc_Location location;
    const Handle(Geom_Surface) own = BRep_Tool::Surface(old, location);
    const Handle(Geom_Surface) surface = standing(own, location);
    built.key.content += surface.IsNull() ? "" : bytes_of(surface);
    put(built.key.content, BRep_Tool::Tolerance(old));
    if (ordered_ && children.size() > 1) {
      const TopoDS_Wire outer = BRepTools::OuterWire(old);
      std::stable_partition(children.begin(), children.end(),
                            [&](const TopoDS_Shape& child) { return child.IsSame(outer); });
    }
    BRep_Builder builder;
    TopoDS_Face out;
    builder.MakeFace(out, surface, BRep_Tool::Tolerance(old));
    builder.NaturalRestriction(out, BRep_Tool::NaturalRestriction(old));
    for (const TopoDS_Shape& child : children) {
      builder.Add(out, made(child));
    }
    flags(old, out);
    built.shape = out;
    return built;
  }

  // Shells, solids and groups; of a solid the outer shell first.
  Built group(const TopoDS_Shape& old) const {
    std::vector<TopoDS_Shape> children = sorted(old);
    Built built;
    built.key = key_of(children);
    if (ordered_ && old.ShapeType() == TopAbs_SOLID && children.size() > 1) {
      const TopoDS_Shell outer = BRepClass3d::OuterShell(TopoDS::Solid(old));
      std::stable_partition(children.begin(), children.end(),
                            [&](const TopoDS_Shape& child) { return child.IsSame(outer); });
    }
    TopoDS_Shape out = old.EmptyCopied();
    out.Location(TopLoc_Location());
    out.Orientation(TopAbs_FORWARD);
    BRep_Builder builder;
    for (const TopoDS_Shape& child : children) {
      builder.Add(out, made(child));
    }
    flags(old, out);
    out.Checked(Standard_False);
    built.shape = out;
    return built;
  }

  struct Moved {
    Handle(Geom_Surface) from;
    TopLoc_Location at;
    Handle(Geom_Surface) to;
  };

  TopoDS_Shape root_;
  bool ordered_;
  std::vector<Moved> moved_;
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_;
  TopTools_IndexedDataMapOfShapeListOfShape face_of_wire_;
  TopTools_DataMapOfShapeShape made_;
  TopTools_DataMapOfShapeInteger ranks_;
  TopTools_DataMapOfShapeInteger turned_;
  std::map<int, Place> places_;
  int rank_ = 0;
};

}  // namespace

SolidPtr canonical(const TopoDS_Shape& shape) {
  if (shape.IsNull()) {
    throw Invalid("no shape came out");
  }
  return wrap(Canon(shape, true).perform());
}

// ShapeUpgrade_RemoveLocations and BRepBuilderAPI_Transform break the border where edges or faces of a
// solid have locations of their own, as after a boolean with what was moved.
SolidPtr shape_baked(const Solid& shape) {
  return wrap(Canon(shape_of(shape), false).perform());
}

}  // namespace assemcad
