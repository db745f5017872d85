// SPDX-License-Identifier: Apache-2.0
// Functions of FFmpeg. Its libraries are opened when the first film is made or read. They load a hundred other
// libraries. If poinsot were linked with FFmpeg, every process would load all of them, even for `--help`, and this
// would take four times as long as the rest of the start. Only .cpp files of this folder include this header,
// directly or through another header.
#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/crc.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

namespace poinsot::output {

// FFmpeg functions that poinsot calls, by library. A call of any other function does not link.
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

/// Table of FFmpeg's functions; a call is ffmpeg().av_frame_alloc(). The functions are members, because global
/// functions with these names would replace FFmpeg's own in a program that links FFmpeg and this library.
struct Ffmpeg {
  Ffmpeg();

#define POINSOT_MEMBER(function) decltype(&::function) function;  // NOLINT(bugprone-macro-parentheses): a name
  POINSOT_AVUTIL_FUNCTIONS(POINSOT_MEMBER)
  POINSOT_AVCODEC_FUNCTIONS(POINSOT_MEMBER)
  POINSOT_AVFORMAT_FUNCTIONS(POINSOT_MEMBER)
  POINSOT_SWSCALE_FUNCTIONS(POINSOT_MEMBER)
#undef POINSOT_MEMBER
};

/// Returns FFmpeg's functions. The first call opens the libraries, and may come from any thread. The libraries
/// have the interface versions of the headers with which poinsot was built. A process that gives up its access to
/// files must call ffmpeg() before.
/// @throws core::Error(kEncode) naming the library and its Debian package if one cannot be opened; the next call
///   tries again.
const Ffmpeg& ffmpeg();

}  // namespace poinsot::output
