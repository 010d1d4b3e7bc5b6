#pragma once

namespace fpkcheck::base {

/// While one lives, its thread has files half written: nobody ends the process in between. They may
/// nest, and several threads may have one.
class FilesInHand {
 public:
  FilesInHand();
  ~FilesInHand();
  FilesInHand(const FilesInHand&) = delete;
  FilesInHand& operator=(const FilesInHand&) = delete;
};

/// To be called before the process is ended by another thread than the one that works: waits until
/// nobody has files in hand. From then on only the calling thread may have any; others that want to
/// wait for the end of the process.
void reserve_files_for_this_thread();

}  // namespace fpkcheck::base
