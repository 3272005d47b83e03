// painted FILE OUT: the draft with the first cell of its tie-up turned, saved as the editor saves it. `./check web`
// holds what a browser saves after the same click against it.

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

#include "wif/wif.h"

int main(int argc, char** argv) {
  using weftlight::wif::WifRead, weftlight::wif::read_wif, weftlight::wif::write_wif;
  if (argc != 3) return 2;
  std::ifstream in(argv[1], std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const WifRead read = read_wif(bytes);
  if (!read.file) return 3;
  weftlight::design::Design design = read.file->design;
  design.draft.tieup.set(0, 0, !design.draft.tieup.get(0, 0));
  std::ofstream out(argv[2], std::ios::binary);
  out << write_wif(*read.file, design);
  return out ? 0 : 5;
}
