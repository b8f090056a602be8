#include <Message.hxx>
#include <Message_Messenger.hxx>

#include "shim.h"

namespace assemcad {

void quiet() {
  // OCCT prints statistics to stdout, which may carry a protocol.
  Message::DefaultMessenger()->ChangePrinters().Clear();
}

}  // namespace assemcad
