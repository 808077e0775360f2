#pragma once
// mien: a face goes in on the left, pixels come out on the right.
//
//   const auto face  = mien::read_face("faces/toon.face.json");               // file  -> Face
//   const auto posed = mien::pose_face(*face, {.time = 1.25});                // Face  -> Face
//   const auto scene = mien::scene_from_face(posed);                          // Face  -> Scene
//   const auto image = mien::render(scene, {.width = 7680, .height = 4320});  // Scene -> Image
//   mien::write_image(*image, "toon.png");  // <mien/write.h>                    Image -> file
//
// A verb that fails says so in a sentence: the first and the last by their files, render where memory
// does not hold the pixels. No global state, nothing
// printed, no exception crosses the API, every verb re-entrant.

#include <mien/face_file.h>
#include <mien/pose.h>
#include <mien/render.h>
#include <mien/renderer.h>
#include <mien/scene_from_face.h>
#include <mien/version.h>
