"${ZPG:-zpg}" check scenes --format json >"$out/findings.json" || [ $? -eq 1 ]
"${ZPG:-zpg}" sheet "$out" -o "$out/sheet.html"
