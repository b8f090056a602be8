#include <Message.hxx>
#include <Message_Messenger.hxx>

#include <iostream>

#include "shim.h"

namespace assemcad {

void quiet() {
  // OCCT prints statistics to stdout, which may carry a protocol; some of it past its messenger.
  Message::DefaultMessenger()->ChangePrinters().Clear();
  std::cout.rdbuf(std::cerr.rdbuf());
}

}  // namespace assemcad
