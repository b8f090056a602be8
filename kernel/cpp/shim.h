// The one header of the wall: the opaque types, what a thrown thing becomes, and the verbs.
//
// OCCT's own headers stay out of here but for the shape handle, so that the bridge compiles fast.
#pragma once

#include <cstdint>
#include <exception>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>

#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>
#include <TopoDS_Shape.hxx>

#include "rust/cxx.h"

namespace assemcad {

// Thrown where the input or its geometry is at fault; the text is a plain phrase.
struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Thrown where an operation ended without a usable result.
struct Invalid : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace assemcad

// cxx catches std::exception only, and Standard_Failure is none: what is not caught here ends the
// process. The first letter says the kind; `error.rs` reads it.
namespace rust {
namespace behavior {
template <typename Try, typename Fail>
static void trycatch(Try&& func, Fail&& fail) noexcept try {
  func();
} catch (const Standard_OutOfMemory&) {
  fail("M");
} catch (const std::bad_alloc&) {
  fail("M");
} catch (const assemcad::Refused& e) {
  fail(std::string("R") + e.what());
} catch (const assemcad::Invalid& e) {
  fail(std::string("I") + e.what());
} catch (const Standard_Failure& e) {
  // The message is often empty: the type then says at least something.
  const char* text = e.GetMessageString();
  std::string all = std::string("K") + e.DynamicType()->Name();
  if (text != nullptr && *text != '\0') {
    all = all + ": " + text;
  }
  fail(all);
} catch (const std::exception& e) {
  fail(std::string("X") + e.what());
} catch (...) {
  fail("Xsomething that is no exception was thrown");
}
}  // namespace behavior
}  // namespace rust

namespace assemcad {

struct Solid {
  TopoDS_Shape shape;
};
using SolidPtr = std::unique_ptr<Solid>;

class StepDoc;
using StepDocPtr = std::unique_ptr<StepDoc>;

// Shared with Rust; defined in the generated header.
struct At;
struct Pose;
struct BoundsRaw;
struct BoresRaw;
struct MassRaw;
struct CheckRaw;
struct FaceRaw;
struct EdgeRaw;
struct DistanceRaw;
struct CommonRaw;
struct AreaRaw;
struct MeshRaw;
struct SkinRaw;
struct HeaderRaw;
struct LeafRaw;

using Bytes = rust::Slice<const std::uint8_t>;
using Reals = rust::Slice<const double>;
using Indices = rust::Slice<const std::uint32_t>;

// start.cpp
void quiet();

// primitives.cpp
SolidPtr make_box(const At& at, double dx, double dy, double dz);
SolidPtr make_cylinder(const At& at, double radius, double height);
SolidPtr make_cone(const At& at, double base, double top, double height);
SolidPtr make_sphere(const At& at, double radius);

// place.cpp
bool has_locations(const Solid& solid);

// query.cpp
BoundsRaw bounds(const Solid& solid, const Pose& pose);
MassRaw mass(const Solid& solid);
CheckRaw check(const Solid& solid);
rust::Vec<std::uint8_t> classify(const Solid& solid, Reals points, double tolerance);
BoresRaw bores(const Solid& solid, const At& from, double radius, double depth);

// facts.cpp
rust::Vec<FaceRaw> faces(const Solid& solid);
rust::Vec<EdgeRaw> edges(const Solid& solid);

// pair.cpp
DistanceRaw distance(const Solid& a, const Pose& at_a, const Solid& b, const Pose& at_b);
CommonRaw common_part(const Solid& a, const Pose& at_a, const Solid& b, const Pose& at_b);
AreaRaw face_common(const Solid& a, const Pose& at_a, std::uint32_t face_a, const Solid& b,
                    const Pose& at_b, std::uint32_t face_b);

// mesh.cpp
MeshRaw mesh(const Solid& solid, double deflection, double angle);

// skin.cpp
SkinRaw skin(const Solid& solid, double deflection, double angle);

// io.cpp
rust::Vec<std::uint8_t> to_bytes(const Solid& solid);
SolidPtr from_bytes(Bytes bytes);

// step_write.cpp
class StepDoc {
 public:
  StepDoc();
  ~StepDoc();
  std::uint32_t add_part(rust::Str name, const Solid& solid, Reals color);
  std::uint32_t add_assembly(rust::Str name);
  void add_instance(std::uint32_t assembly, std::uint32_t of, rust::Str name, const Pose& pose);
  rust::Vec<std::uint8_t> write(const HeaderRaw& header);

 private:
  struct Inner;
  std::unique_ptr<Inner> inner;
};
StepDocPtr step_doc();

// step_read.cpp
rust::Vec<LeafRaw> read_step(Bytes bytes);

}  // namespace assemcad
