"""The robot in the browser: a description as a scene, and the page that shows it."""
