#pragma once

namespace fpkcheck::base {

/// While a guard exists, its thread has incomplete files and no other thread ends the process.
/// Guards nest, and several threads may hold one at the same time.
class FilesInHand {
 public:
  FilesInHand();
  ~FilesInHand();
  FilesInHand(const FilesInHand&) = delete;
  FilesInHand& operator=(const FilesInHand&) = delete;
};

/// Waits until no guard exists, then allows guards to the calling thread only. Call before ending
/// the process from a thread other than the working one. Other threads that construct a guard later
/// block until the process exits.
void reserve_files_for_this_thread();

}  // namespace fpkcheck::base
