// SPDX-License-Identifier: Apache-2.0
// Films play while they are in view, and stop at a click; who asked for less motion starts them with one. Without
// scripts they have the browser's own buttons.
const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
const seen = new IntersectionObserver((entries) => {
  for (const { target, isIntersecting } of entries)
    if (!isIntersecting) target.pause();
    else if (!still && !target.stopped) target.play().catch(() => {});
}, { threshold: 0.4 });

function toggle(film) {
  film.stopped = !film.paused;
  if (film.stopped) film.pause();
  else film.play();
}

// A film is some seconds of a longer one: it fades out and in where it begins anew, in place of a jump.
const FADE_S = 0.4;

function fade(film) {
  const toEnd_s = film.duration - film.currentTime;
  film.repeats ||= toEnd_s < FADE_S;
  film.style.opacity = Math.min(1, toEnd_s / FADE_S, film.repeats ? film.currentTime / FADE_S : 1);
  if (film.paused) film.style.opacity = 1;
  else requestAnimationFrame(() => fade(film));
}

for (const film of document.querySelectorAll("video.film")) {
  film.controls = false;
  film.tabIndex = 0;
  film.title = "click to stop, and to go on";
  film.addEventListener("click", () => toggle(film));
  film.addEventListener("keydown", (event) => {
    if (event.key !== " " && event.key !== "Enter") return;
    event.preventDefault();
    toggle(film);
  });
  film.addEventListener("play", () => fade(film));
  seen.observe(film);
}
