#include "methods/builtin.hpp"

namespace fpkcheck::methods {

Registry builtin_registry() {
  Registry registry;
  registry.add(epc_solver());
  registry.add(fd_solver());
  registry.add(mcs_solver());
  return registry;
}

}  // namespace fpkcheck::methods
