#pragma once
// The version of mien. This is its only definition: the build reads these three numbers.

#define MIEN_VERSION_MAJOR 0
#define MIEN_VERSION_MINOR 1
#define MIEN_VERSION_PATCH 0

#define MIEN_VERSION_TEXT_(x) #x
#define MIEN_VERSION_JOIN_(a, b, c) \
  MIEN_VERSION_TEXT_(a) "." MIEN_VERSION_TEXT_(b) "." MIEN_VERSION_TEXT_(c)
#define MIEN_VERSION_STRING \
  MIEN_VERSION_JOIN_(MIEN_VERSION_MAJOR, MIEN_VERSION_MINOR, MIEN_VERSION_PATCH)
