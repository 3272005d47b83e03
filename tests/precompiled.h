#pragma once
// As core/base/precompiled.h, for tests.
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <thread>

#include "../core/base/precompiled.h"
