# SPDX-License-Identifier: Apache-2.0
# The headers that a caller of each layer starts from. They are installed with all that they include; the rest of src/
# is internal. To make one public is to name it here.
set(POINSOT_PUBLIC_HEADERS
  core/error.h core/file_error.h core/interruption.h core/rational.h core/sha256.h core/version.h
  physics/binet.h physics/catalogue.h physics/composition.h physics/driven_motion.h physics/flight.h
  physics/forcing.h physics/free_motion.h physics/heavy_top.h physics/herpolhode.h physics/inertia_tensor.h
  physics/mass_properties.h physics/particle_system.h physics/poinsot_construction.h physics/polhode.h
  physics/possible_inertia.h physics/precession_cones.h physics/principal_axes.h physics/run_condition.h physics/solid.h physics/stability.h
  physics/start.h
  geometry/mesh.h geometry/mesh_file.h geometry/mesh_integrals.h geometry/primitives.h
  compare/changes.h compare/difference.h compare/flip.h image/image.h compare/magma.h compare/near_rule.h image/png_file.h
  gl/offscreen_context.h
  scene/motion/film_clock.h scene/limits.h scene/motion/make_motion.h scene/keys/reference.h scene/scene.h scene/scene_file.h
  scene/units.h
  draw/camera.h draw/color.h draw/draw_list.h draw/picture.h draw/picture_digest.h
  text/coverage.h text/math_setter.h text/plain_text.h
  output/animation.h core/atomic_file.h figure/figure.h output/film.h output/film_reader.h output/png_sequence.h output/video_segment.h
  stage/stage.h
  render/reference.h render/renderer.h
  describe/alt_text.h compare/film_diff.h compare/folder_diff.h golden/suite.h reference/grade.h reference/grade_text.h process/interrupt.h compare/picture_diff.h job/render_job.h describe/report_scene.h
  request/scene_request.h job/still_batch.h reference/trajectory_text.h job/worker.h)
