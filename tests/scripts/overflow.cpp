// SPDX-License-Identifier: Apache-2.0
//
// Undefined behaviour: an overflow of int. Its exit status is 0 where it goes on after that.
#include <limits>

int main(int arguments, char**) {
  const volatile int sum = std::numeric_limits<int>::max() + arguments;
  return sum == 0 ? 1 : 0;
}
