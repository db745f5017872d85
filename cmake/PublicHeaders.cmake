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
  image/changes.h image/difference.h image/flip.h image/image.h image/magma.h image/near_rule.h image/png_file.h
  gl/offscreen_context.h
  scene/film_clock.h scene/limits.h scene/make_motion.h scene/reference.h scene/scene.h scene/scene_file.h
  scene/units.h
  draw/camera.h draw/color.h draw/draw_list.h draw/picture.h draw/picture_digest.h
  text/coverage.h text/math_setter.h text/plain_text.h
  output/animation.h output/atomic_file.h output/figure.h output/film.h output/film_reader.h output/png_sequence.h output/video_segment.h
  stage/stage.h
  render/reference.h render/renderer.h
  app/alt_text.h app/film_diff.h app/folder_diff.h app/golden_suite.h app/grade.h app/grade_text.h app/interrupt.h app/picture_diff.h app/render_job.h app/report_scene.h
  app/scene_request.h app/still_batch.h app/trajectory_text.h app/worker.h)
