// SPDX-License-Identifier: Apache-2.0
// Functions of FFmpeg, in libraries that are opened when the first film is made or read. These libraries load a
// hundred others. If poinsot were linked with them, the dynamic loader would bind all in every process, even for
// `--help`, and take four times as long as the rest of a start. Included by .cpp files of this folder only, as is
// every header that includes it.
#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/crc.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

namespace poinsot::output {

// Functions that poinsot calls, by library. A call of another function does not link.
// clang-format off
#define POINSOT_AVUTIL_FUNCTIONS(X)                                                                         \
  X(av_crc) X(av_crc_get_table) X(av_dict_free) X(av_dict_get) X(av_dict_set) X(av_frame_alloc)             \
  X(av_frame_free) X(av_frame_get_buffer) X(av_frame_make_writable) X(av_free) X(av_freep)                  \
  X(av_get_padded_bits_per_pixel)                                                                           \
  X(av_log_format_line) X(av_log_set_callback) X(av_malloc) X(av_mul_q) X(av_pix_fmt_desc_get)              \
  X(av_rescale_q) X(av_strdup) X(av_strerror)

#define POINSOT_AVCODEC_FUNCTIONS(X)                                                                        \
  X(av_packet_alloc) X(av_packet_free) X(av_packet_make_writable) X(av_packet_unref) X(av_shrink_packet)    \
  X(avcodec_alloc_context3) X(avcodec_find_decoder) X(avcodec_find_decoder_by_name)                         \
  X(avcodec_find_encoder_by_name) X(avcodec_free_context) X(avcodec_descriptor_get) X(avcodec_get_name)     \
  X(avcodec_open2)                                                                                          \
  X(avcodec_parameters_alloc) X(avcodec_parameters_copy) X(avcodec_parameters_free)                         \
  X(avcodec_parameters_from_context) X(avcodec_parameters_to_context) X(avcodec_receive_frame)              \
  X(avcodec_receive_packet) X(avcodec_send_frame) X(avcodec_send_packet) X(avcodec_version)

#define POINSOT_AVFORMAT_FUNCTIONS(X)                                                                       \
  X(av_find_best_stream) X(av_find_input_format) X(av_guess_frame_rate) X(av_read_frame) X(av_write_frame)  \
  X(av_write_trailer) X(avformat_alloc_output_context2) X(avformat_close_input)                             \
  X(avformat_find_stream_info) X(avformat_free_context) X(avformat_new_stream) X(avformat_open_input)       \
  X(avformat_version) X(avformat_write_header) X(avio_alloc_context) X(avio_context_free) X(avio_flush)

#define POINSOT_SWSCALE_FUNCTIONS(X)                                                                        \
  X(sws_freeContext) X(sws_getCoefficients) X(sws_getContext) X(sws_scale) X(sws_setColorspaceDetails)
// clang-format on

/// Table of FFmpeg's functions by name: ffmpeg().av_frame_alloc(). The functions are members, because global
/// functions of these names would also catch the calls of a program that links FFmpeg beside this library.
struct Ffmpeg {
  Ffmpeg();

#define POINSOT_MEMBER(function) decltype(&::function) function;  // NOLINT(bugprone-macro-parentheses): a name
  POINSOT_AVUTIL_FUNCTIONS(POINSOT_MEMBER)
  POINSOT_AVCODEC_FUNCTIONS(POINSOT_MEMBER)
  POINSOT_AVFORMAT_FUNCTIONS(POINSOT_MEMBER)
  POINSOT_SWSCALE_FUNCTIONS(POINSOT_MEMBER)
#undef POINSOT_MEMBER
};

/// Returns FFmpeg's functions. The first call, from any thread, opens the libraries, in the interface versions of
/// the build's headers. A process that gives up access to files has to call ffmpeg() first.
/// @throws core::Error(kEncode) naming the library and its Debian package if one cannot be opened; the next call
/// tries again.
const Ffmpeg& ffmpeg();

}  // namespace poinsot::output
