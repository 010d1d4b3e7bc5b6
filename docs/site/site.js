// The style sheet of furo in Debian 12 has no rule for body[data-theme="auto"] in a dark desktop. This script replaces
// "auto" by the theme of the desktop.
(() => {
  const dark = window.matchMedia("(prefers-color-scheme: dark)");
  const body = document.body;
  const resolve = () => {
    if (body.dataset.theme === "auto") body.dataset.theme = dark.matches ? "dark" : "light";
  };
  new MutationObserver(resolve).observe(body, { attributes: true, attributeFilter: ["data-theme"] });
  resolve();
})();
