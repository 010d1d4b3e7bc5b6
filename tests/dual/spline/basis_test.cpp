#include "dual/spline/basis.hpp"

#include <gtest/gtest.h>
