// node gltf_validator.js PACKAGE: reads paths of glTF files from standard input, one a line, and prints for each a line
// of JSON: what Khronos' validator finds there, {"code": [[severity, pointer, message], ...]}; severity 0 is an error.
const fs = require("fs");
const path = require("path");
const validator = require(process.argv[2]);

const beside = (file) => (uri) =>
  fs.promises.readFile(path.join(path.dirname(file), decodeURIComponent(uri)));

const validate = async (file) => {
  const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), {
    maxIssues: 0, // all
    externalResourceFunction: beside(file),
  });
  const found = {};
  for (const { code, severity, pointer, message } of report.issues.messages) {
    (found[code] ??= []).push([severity, pointer ?? "", message]);
  }
  return found;
};

(async () => {
  const files = fs.readFileSync(0, "utf8").split("\n").filter((line) => line !== "");
  for (const file of files) console.log(JSON.stringify(await validate(file)));
})();
