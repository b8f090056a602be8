#include <BinTools.hxx>

#include <sstream>

#include "common.h"

namespace assemcad {

rust::Vec<std::uint8_t> to_bytes(const Solid& solid) {
  std::ostringstream stream(std::ios::binary);
  // The version is fixed: bytes are hashed and kept.
  BinTools::Write(shape_of(solid), stream, Standard_False, Standard_False,
                  BinTools_FormatVersion_VERSION_4);
  if (!stream.good()) {
    throw Invalid("it could not be written");
  }
  const std::string text = stream.str();
  rust::Vec<std::uint8_t> out;
  out.reserve(text.size());
  for (const char c : text) {
    out.push_back(static_cast<std::uint8_t>(c));
  }
  return out;
}

SolidPtr from_bytes(Bytes bytes) {
  std::istringstream stream(
      std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()), std::ios::binary);
  TopoDS_Shape shape;
  BinTools::Read(shape, stream);
  if (shape.IsNull()) {
    throw Refused("the bytes hold no shape");
  }
  return wrap(shape);
}

}  // namespace assemcad
