#pragma once
// mien: a face goes in on the left, pixels come out on the right.
//
//   const auto face  = mien::read_face("faces/toon.face.json");               // file  -> Face
//   const auto posed = mien::pose_face(*face, {.time = 1.25});                // Face  -> Face
//   const auto scene = mien::scene_from_face(posed);                          // Face  -> Scene
//   const auto image = mien::render(scene, {.width = 7680, .height = 4320});  // Scene -> Image
//   mien::write_image(*image, "toon.png");  // <mien/write.h>                    Image -> file
//
// Three verbs can fail, and each returns the reason in a sentence: reading and writing for their files, and
// render when memory does not hold the pixels. The API keeps no global state, prints nothing and lets no
// exception out. Every verb is re-entrant. Where memory runs out, what returns an Expected returns an error; all else,
// pose_face and scene_from_face among it, has no error to return and lets std::bad_alloc out.

#include <mien/face_file.h>
#include <mien/pose.h>
#include <mien/render.h>
#include <mien/renderer.h>
#include <mien/scene_from_face.h>
#include <mien/version.h>
