### Nápověda příkazové řádky, česky. Anglicky je v komentářích u příkazů; help.rs říká, co je co.

## Slova, která má clap jen anglicky

help-word-usage = Použití:
help-word-commands = Příkazy:
help-word-arguments = Argumenty:
help-word-options = Volby:
help-word-any-options = [VOLBY]
help-word-any-command = [PŘÍKAZ]
help-word-command = <PŘÍKAZ>
help-word-default = [výchozí:
help-word-values = [možnosti:
help-word-values-below = Možnosti:
help-word-help-command = Vypíše tuto nápovědu, nebo nápovědu k příkazu
help-word-help-of-commands = Příkaz, ke kterému se má vypsat nápověda
help-word-help-more = Vypíše nápovědu (podrobnější vypíše --help)
help-word-help-less = Vypíše nápovědu (stručnou vypíše -h)
help-word-help = Vypíše nápovědu
help-word-version = Vypíše verzi

## Co mají všechny příkazy

help-any-color = Kdy psát barevně
    .value = KDY
    .auto = na terminálu, není-li nastaveno NO_COLOR
    .always = vždy
    .never = nikdy
help-any-lang = Jazyk zpráv [výchozí: podle LC_ALL, LC_MESSAGES nebo LANG]
    .value = JAZYK
    .en = anglicky
    .cs = česky
help-any-quiet = Vypisovat jen nálezy, odpovědi a chyby, nic dalšího

## Co má více příkazů

help-any-file = Scéna, jako záznamy nebo JSON; `-` je standardní vstup
    .value = SOUBOR
help-any-allowed = Odmítnout, co by zabralo víc paměti než toto množství, například 800M nebo 12G [výchozí: polovina dostupné]
    .value = KOLIK
help-any-paths = Soubory nebo složky se scénami [výchozí: .]; `-` je standardní vstup
    .value = CESTA
help-any-config = Soubor s nastavením, který platí místo všech zpg.toml, nebo jedno nastavení, které má přednost před každým souborem, například `lint.W310="off"`
    .value = SOUBOR|KLÍČ=HODNOTA
help-any-isolated = Nečíst žádný zpg.toml
help-any-force_exclude = Vynechat, co vylučuje nastavení, i když to CESTA uvádí jménem
help-any-json = Vypsat odpověď jako JSON

## zpg

help-zpg = Nástroje pro scény v jazyce ZPG
    .after =
        Návratový kód: 0 hotovo a bez chyb; 1 scéna má chyby, nebo odpověď zní „ne“; 2 špatné použití, nebo
        soubor nelze přečíst či zapsat, nebo není scénou.

        Příklady:
          zpg check scena.zpg       co je ve scéně špatně
          zpg fmt scena.zpg         jeden záznam na řádek, čísla zapsaná co nejkratším způsobem
          zpg render scena.zpg      obrázek, scena.png
          zpg plan scena.zpg        které efekty obrázek potřebuje a proč
          zpg accuracy scena.zpg    kolik času stojí jednotlivé kroky přesnosti
          zpg convert scena.zpg --to pov -o scena.pov
          zpg crosscheck scena.zpg --with povray
          zpg probe scena.zpg --ray "0 0 9  0 0 -1"
          zpg explain E101          co nález znamená a jak ho opravit
          zpg explain koule         co znamená typ záznamu a jak se píše

## zpg check

help-check = Hledá ve scénách chyby
    .after =
        Nálezy jdou na standardní výstup. Návratový kód je 0, když není žádná chyba, 1, když nějaká je (nebo --diff
        ukazuje změnu), a 2, když soubor nelze přečíst či zapsat, nebo když není scénou: do takového souboru se nikdy
        nic nezapíše.

        KÓD je kód (W307), název (overlapping-union), začátek kódů (W3), nebo jedno ze slov warnings, notes, style
        a all. Úrovně pro celou složku scén se píší do zpg.toml; komentář `# zpg: allow(W307) #` povolí nález tam,
        kde stojí. Z voleb --select, --ignore a --deny platí ta, která uvádí méně kódů. Chyby jazyka se hlásí vždy.

        Scéna v JSON (SOUBOR.json) se kontroluje stejně jako scéna ze záznamů, ale --fix, --diff a --add-allow ji
        odmítnou.

        Nastavení ze zpg.toml lze udat i volbou --config. Jeho `exclude` vynechává soubory a složky, na které se
        cestou narazí, a `per-file-ignores` vynechává v některých souborech některé kódy.

        Příklady:
          zpg check                            všechny *.zpg v této složce a pod ní
          zpg check scena.zpg
          zpg check sceny/                     všechny *.zpg ve složce, kromě těch z .gitignore
          zpg check --fix scena.zpg            opraví, co je jisté
          zpg check --add-allow sceny/         co zbývá, povolí komentáři
          zpg check --diff scena.zpg           ukáže, co by --fix změnil
          zpg check --deny warnings sceny/     pro průběžnou integraci
          zpg check --format short sceny/      jeden řádek na nález
          zpg check --format json - < scena.zpg
          zpg check --format sarif --output-file zpg.sarif sceny/
          zpg check --isolated --config 'lint.W310="off"' sceny/

        Víc o nálezu řekne `zpg explain E101`.
help-check-format = Jak nálezy vypsat
    .value = TVAR
    .human = s příslušnými řádky, poznámkami a návrhy oprav
    .short = jeden řádek na nález
    .json = pro programy
    .sarif = pro přehledy nálezů v kódu: SARIF 2.1.0
    .github = pro GitHub Actions: poznámky u změn
help-check-output_file = Zapsat nálezy do souboru místo na standardní výstup
    .value = SOUBOR
help-check-exit_zero = Skončit s návratovým kódem 0, i když jsou ve scénách chyby; 2 zůstává 2
help-check-show_files = Vypsat soubory, které by se kontrolovaly
help-check-show_settings = Vypsat nastavení prvního souboru tak, jak by mohlo stát v jeho zpg.toml
help-check-fix = Opravit přímo v souboru, co lze opravit bezpečně; scéna ze standardního vstupu jde na standardní výstup
help-check-add_allow = Doplnit komentáře, které povolí všechny zbývající nálezy; chyby povolit nelze
help-check-unsafe_fixes = Spolu s --fix nebo --diff: použít i opravy, které jsou odhadem
help-check-diff = Nic nezapisovat; ukázat, co by --fix změnil
help-check-select = Hlásit jen tyto kódy (a chyby)
    .value = KÓD
help-check-ignore = Tyto kódy nehlásit
    .value = KÓD
help-check-deny = Brát tyto kódy jako chyby
    .value = KÓD
help-check-statistics = Místo výpisu nálezů jen spočítat, kolik jich je od každého kódu (jako text nebo JSON)
help-check-stdin_filename = Jak se jmenuje standardní vstup: ve zprávách, pro zpg.toml a pro obrázky
    .value = JMÉNO
help-check-watch = Zkontrolovat znovu po každé změně souboru

## zpg fmt

help-fmt = Zformátuje scény: jeden záznam na řádek, čísla a komentáře pod sebou
    .after =
        Soubory se přepisují na místě; `-` zformátuje standardní vstup na standardní výstup. Řádky s chybami zůstávají,
        jak jsou, stejně jako kódování a konce řádků. S --check nebo --diff se nic nezapisuje a návratový kód je 1, když
        by se něco změnilo. Do souboru, který není scénou, se nikdy nic nezapíše; návratový kód je 2.

        Styl lze zvolit v souboru zpg.toml, v nejbližším směrem od scény nahoru, nebo volbou --config. Jeho `exclude`
        vynechává soubory a složky. Výchozí styl je:
          {"["}format]
          width = 100                    kde se lámou profily a kam až sahá zarovnání
          align = true                   čísla a komentáře sousedních řádků pod sebou
          group = true                   vektory jednoho záznamu odděleny dvěma mezerami
          numbers = "shortest"           nebo "keep": jak jsou zapsána

        Příklady:
          zpg fmt                        všechny *.zpg v této složce a pod ní
          zpg fmt scena.zpg
          zpg fmt sceny/                 všechny *.zpg ve složce, kromě těch z .gitignore
          zpg fmt --diff scena.zpg       co by se změnilo
          zpg fmt --check sceny/         pro průběžnou integraci
          zpg fmt --range 3-9 scena.zpg  jen řádky 3 až 9
          zpg fmt - < vstup.zpg > vystup.zpg
help-fmt-check = Nic nezapisovat; vyjmenovat soubory, které by se změnily
help-fmt-diff = Nic nezapisovat; ukázat, co by se změnilo
help-fmt-range = Změnit jen záznamy, které zasahují do těchto řádků, počítáno od 1; pro jediný soubor
    .value = OD-DO
help-fmt-stdin_filename = Jak se jmenuje standardní vstup: ve zprávách a pro zpg.toml
    .value = JMÉNO

## zpg convert

help-convert = Převede scénu pro jiný program
    .after =
        Každý převod končí zprávou na chybovém výstupu: co ze scény je jen přibližné a o kolik, co je vynecháno a kolik
        vlastností je přesných; s --verbose jsou vyjmenovány i ty.

        Příklady:
          zpg convert scena.zpg --to pov -o scena.pov
          zpg convert scena.zpg --to mitsuba -o scena.xml
          zpg convert scena.zpg --to glb --tolerance 0.01
          zpg convert scena.zpg --to json | jq .nodes
          zpg convert vytvorena-programem.json --to zpg
help-convert-to = Do čeho scénu převést
    .value = CÍL
    .pov = POV-Ray 3.7, jeden soubor
    .mitsuba = Mitsuba 3: XML, sítě vedle něj
    .ply = trojúhelníky: Stanford PLY, binární, s barvami
    .obj = trojúhelníky: Wavefront OBJ, vedle něj knihovna materiálů
    .glb = trojúhelníky: glTF 2.0, binární
    .json = vyhodnocená scéna, pro programy
    .zpg = vyhodnocená scéna jako záznamy
help-convert-output = Kam zapisovat. Není-li udáno, na standardní výstup, a síť do souboru SCÉNA.ply (obj, glb) v této složce. Stereoskopická dvojice se zapíše do JMÉNO_left a JMÉNO_right; na standardním výstupu je to jeden soubor s přepínačem. Vedle JMÉNO.obj je JMÉNO.mtl a obrázek každé textury, JMÉNO_texture_0.png a další; vedle JMÉNO.xml jsou takové obrázky a sítě JMÉNO_1.ply a další
    .value = SOUBOR
help-convert-size = Velikost obrázku, pro který kamera je, v pixelech
    .value = ŠxV
help-convert-depth = Kolikrát se paprsek smí odrazit nebo lomit
    .value = N
help-convert-tolerance = Jak daleko smějí být sítě od zakřivených ploch, v jednotkách scény; není-li udáno, tisícina velikosti scény
    .value = DÉLKA
help-convert-verbose = Vyjmenovat i to, co je přesné, vlastnost po vlastnosti
help-convert-report = Zapsat zprávu o věrnosti převodu i jako JSON
    .value = SOUBOR.json

## zpg crosscheck

help-crosscheck = Porovná, co ze scény vidíme my a co jiný program
    .after =
        Scéna se převede, program se na ni podívá a oba pohledy se porovnají pixel po pixelu. Odpověď zní „ne“,
        s návratovým kódem 1, když se mimo obrysy liší více než 0,05 % pixelů.

        povray: obrázky, v lineárním světle. Na obrysech, kde hrana prochází středem pixelu, rozhoduje o jediném
        vzorku zaokrouhlení; a POV-Ray zachází jinak s úplným odrazem: obojí se počítá zvlášť.
        mitsuba: poloha, normála a těleso, které je vidět jako první, z Pythonu, který má balíček mitsuba. Co jednoduchá
        přesnost nerozezná, a která ze dvou ploch na jednom místě je vidět, se počítá zvlášť; odpověď zní „ne“ i tehdy,
        když je toho více než toho, co je vidět stejně.

        Ve složce SLOŽKA pak jsou ours.png, theirs.png, difference.png (zelená: stejné, červená: jiné, šedá: obrysy,
        u povray ty, které se liší; modrá: co se počítá zvlášť), side-by-side.png, crosscheck.json a převod; u dvojice
        kamer s příponami _left a _right. Obrázky z mitsuba ukazují normály jako barvy.

        Příklady:
          zpg crosscheck scena.zpg --with povray
          zpg crosscheck scena.zpg --with povray --size 640x480 -o srovnani --max-diff 1
          zpg crosscheck scena.zpg --with mitsuba --program venv/bin/python
help-crosscheck-file = Scéna
    .value = SOUBOR
help-crosscheck-with = Program
    .value = PROGRAM
    .povray = POV-Ray 3.7
    .mitsuba = Mitsuba 3
help-crosscheck-size = Velikost obrázků v pixelech; nejvýše 16777216 pixelů
    .value = ŠxV
help-crosscheck-output = Složka pro obrázky a čísla; není-li udána, SCÉNA-povray nebo SCÉNA-mitsuba
    .value = SLOŽKA
help-crosscheck-max_diff = povray: o kolik se smí lišit kanál pixelu, v 255inách bílé
    .value = N
help-crosscheck-depth = povray: kolikrát se paprsek smí odrazit nebo lomit
    .value = N
help-crosscheck-tolerance = mitsuba: jak daleko smějí být sítě od zakřivených ploch, jako u convert
    .value = DÉLKA
help-crosscheck-program = Kde program je, nenajde-li se podle jména: povray, nebo python3
    .value = CESTA
help-crosscheck-json = Vypsat čísla jako JSON

## zpg render

help-render = Vykreslí scénu
    .after =
        Bez -o se obrázek scény SCÉNA.zpg zapíše do SCÉNA.png v této složce. PNG je osmibitové sRGB, EXR a PFM mají
        lineární neoříznutá 32bitová čísla. Co bylo zapsáno, se vypíše na standardní výstup; s `-o -` tam jde samo PNG.
        Scéna se stereoskopickou kamerou dá dva obrázky, SCÉNA_left.png a SCÉNA_right.png, neříká-li --stereo něco
        jiného. Po Ctrl-C nezůstane žádný soubor.

        Příklady:
          zpg render scena.zpg
          zpg render scena.zpg -o velky.png --size 1920x1080 --samples 16
          zpg render scena.zpg -o film.exr --adaptive 0.01
          zpg render scena.zpg -o - | convert - scena.jpg
          zpg render scena.zpg --cost
          zpg render scena.zpg --crop 200,100,64,64 --stats naklady.json
help-render-output = Kam obrázek zapsat: .png, .exr nebo .pfm; `-` je standardní výstup
    .value = VÝSTUP
help-render-size = Šířka a výška v pixelech
    .value = ŠxV
help-render-samples = Počet vzorků v každém pixelu; jeden leží v jeho středu
    .value = N
help-render-adaptive = Až 1024 vzorků, dokud odhad chyby pixelu v lineárním RGB neklesne pod tuto mez
    .value = MEZ
help-render-depth = Kolikrát se paprsek smí odrazit nebo lomit
    .value = N
help-render-cutoff = Vynechat, co váží méně než toto číslo; 0 nevynechá nic [výchozí: 1/4096]
    .value = VÁHA
help-render-precision = Čísla, kterými se počítá mezi paprskem a tím, co zasáhne
    .value = ČÍSLA
    .f32 = jednoduchá přesnost, jak je
    .f64 = dvojitá přesnost; co nerozhodne, rozhodne dd
    .dd = dvojice čísel dvojité přesnosti (double-double), asi 32 číslic
help-render-crop = Vykreslit jen tuto část obrázku
    .value = X,Y,Š,V
help-render-camera = Kamera scény, kterou se má obrázek pořídit
    .value = ID
help-render-stereo = Co se stane se dvěma obrázky stereoskopické kamery [výchozí: pair]
    .value = JAK
    .pair = dva soubory, JMÉNO_left a JMÉNO_right
    .side-by-side = jeden obrázek, levý vedle pravého
    .anaglyph = jeden obrázek pro červenoazurové brýle
help-render-threads = Počet pracovních vláken; 0: kolik je procesorů. Nejvýše čtyřikrát tolik
    .value = N
help-render-stats = Zapsat do souboru jako JSON, co to stálo: časy, paprsky, testy, práci jednotlivých efektů
    .value = SOUBOR
help-render-cost = Vypsat, co to stálo a kde: paprsky, čas, nejdražší objekty a efekty
help-render-heatmap = Nakreslit v nepravých barvách, kolik testů průsečíků připadlo na každý pixel
    .value = VÝSTUP.png

## zpg probe

help-probe = Odpovídá na otázky o paprscích a bodech
    .after =
        Vypíše jeden objekt JSON na řádek, v pořadí paprsků. U paprsku jsou v něm všechny průsečíky s hranicemi těles
        pro t > 0, vzestupně, jako by každá plocha paprsek propouštěla; t se měří v délkách směru. Soubor s paprsky má
        na každém řádku jeden, `ox oy oz dx dy dz`, mezi čísly mohou být čárky; prázdné řádky a vše za znakem # se
        přeskočí. Na řádek, na kterém paprsek není, nebo na jehož čísla přesnost nestačí, je stížnost na chybovém
        výstupu a odpověď k němu chybí; ostatní ji mají a návratový kód je 2. Řádkem delším než 65536 bajtů soubor
        končí.

        `shape` je ID záznamu, z něhož plocha pochází, u kopie její vlastní; `object` je nejvnější objekt nad ním, který
        dostal vlastnosti, jinak totéž co `shape`. Normála míří ven z tělesa, i tam, kde hranice vznikla řezem. Co leží
        mimo kvádr renderovacího záznamu, se nehlásí, ale počítá se do `inside_at_origin`, tedy do stavu těsně za
        počátkem paprsku.

        --point vypíše ID těles, tvarů i operací, v nichž bod leží; hranice tvarů k nim patří. `in_scene` říká, zda bod leží
        v celku, a to uvnitř kvádru renderovacího záznamu. Rozhoduje se ve dvojité přesnosti, a kde ta hranice nespočítá,
        v dd, ať --precision říká cokoli.

        Příklady:
          zpg probe scena.zpg --ray "0 0 9  0 0 -1"
          zpg probe scena.zpg --rays paprsky.txt > pruseciky.jsonl
          zpg probe scena.zpg --pixel 320,240 --size 640x480
          zpg probe scena.zpg --point "0 1 0" --object 4
help-probe-ray = Počátek a směr jednoho paprsku; mezi čísly mohou být čárky
    .value = OX OY OZ DX DY DZ
help-probe-rays = Soubor s paprsky; `-` je standardní vstup
    .value = SOUBOR
help-probe-pixel = Paprsek středem pixelu, počítáno od 0 vlevo nahoře
    .value = X,Y
help-probe-point = Bod
    .value = X Y Z
help-probe-size = Šířka a výška obrázku, ve kterém je --pixel
    .value = ŠxV
help-probe-camera = Kamera, kterou je --pixel vidět; není-li udána, ze stereoskopické dvojice levá
    .value = ID
help-probe-object = Ptát se na tento objekt, jaký je na konci souboru, ne na celou scénu; kvádr renderovacího záznamu neplatí
    .value = ID
help-probe-precision = Čísla, kterými se počítá; u dd jsou t, body a normály texty o 32 číslicích. Na --point nemá vliv
    .value = ČÍSLA
    .f32 = { help-render-precision.f32 }
    .f64 = { help-render-precision.f64 }
    .dd = { help-render-precision.dd }

## zpg plan

help-plan = Řekne, které efekty scéna potřebuje a proč
    .after =
        Efekt se počítá tam, kde může být vidět: přebarvené vlastnosti, nástroje rozdílů, objekty, ke kterým renderovací
        záznam nedosáhne, a části, které žádný paprsek neuvidí, nic nezapínají. Kód vypnutého efektu neběží. Část není
        vidět, leží-li mimo kvádr renderovacího záznamu, nebo celá uvnitř neprůhledného tělesa, které nic neotevírá.

        Příklady:
          zpg plan scena.zpg
          zpg plan scena.zpg --json

## zpg accuracy

help-accuracy = Řekne, kolik času stojí přesnost: co které nastavení obrázku scény přinese a co to stojí
    .after =
        Měří se čtyři druhy chyb, každý proti referenci přesnější než vše, co se zkouší, a s ostatním nastavením takovým,
        jaké má prosté `zpg render`: hrany (samples, adaptive), uříznuté světlo (depth, cutoff), zaokrouhlování
        (precision, solver) a plošky (tessellation, levels). Co scéna nepotřebuje, se nespouští, a zpráva říká proč.
        Samu referenci ověřuje nezávislý sledovač paprsků se 71 číslicemi.

        Z velkého obrázku se měří malé dlaždice, nikdy zmenšený obrázek. Časy jsou nejmenší časy procesoru na jednom
        vlákně z několika běhů v zamíchaném pořadí; časy, které se liší o méně, než je naměřený šum, se neřadí.
        Ve složce SLOŽKA pak jsou accuracy.json, accuracy.md, accuracy.svg a accuracy.html. Ctrl-C zapíše, co je hotovo.

        Příklady:
          zpg accuracy scena.zpg
          zpg accuracy scena.zpg --size 1920x1080 --budget 10m -o zprava
          zpg accuracy scena.zpg --axes samples,adaptive --goal 0.5
          zpg accuracy --shapes
help-accuracy-file = Scéna; `-` je standardní vstup
    .value = SOUBOR
help-accuracy-size = Šířka a výška obrázku v pixelech
    .value = ŠxV
help-accuracy-axes = Nastavení, která se mají zkoušet, oddělená čárkami [výchozí: všechna]
    .value = CO
help-accuracy-runs = Kolikrát se každé nastavení změří [výchozí: 5]
    .value = N
help-accuracy-budget = Kolik času to má asi trvat: 90s, 2m, 1h [výchozí: 2m]
    .value = ČAS
help-accuracy-goal = Chyba, která ještě nevadí, v krocích osmibitového obrázku
    .value = KROKY
help-accuracy-output = Složka pro zprávu; není-li udána, SCÉNA-accuracy
    .value = SLOŽKA
help-accuracy-shapes = Místo toho: čas a chyba jednoho paprsku pro každý tvar, čísla a řešič
help-accuracy-json = Vypsat zprávu jako JSON

## zpg explain

help-explain = Vysvětlí nález nebo typ záznamu
    .after =
        Bez argumentu vypíše všechny kódy a typy záznamů.

        Příklady:
          zpg explain E101            nález podle kódu
          zpg explain undefined-id    … nebo podle názvu
          zpg explain -399            typ záznamu podle čísla
          zpg explain šachovnice      … nebo podle jména, českého či anglického
help-explain-topic = Kód nebo název nálezu, číslo nebo jméno typu záznamu
    .value = KÓD|TYP

## zpg lsp

help-lsp = Jazykový server: nálezy, nápovědy, opravy a další přímo v editoru
    .after =
        Editory si tento příkaz spouštějí samy a mluví s ním na jeho standardním vstupu a výstupu; jak který nastavit,
        říká docs/editors.md. Nastavení se bere ze zpg.toml, jako na příkazové řádce.
help-lsp-stdio = Mluvit na standardním vstupu a výstupu, jako vždy; některé editory to říkají

## zpg completions

help-completions = Vypíše skript, který v shellu doplňuje tuto příkazovou řádku
    .after =
        Příklady:
          zpg completions bash > ~/.local/share/bash-completion/completions/zpg
          zpg completions fish > ~/.config/fish/completions/zpg.fish
          zpg completions zsh  > soubor _zpg ve složce z $fpath
help-completions-shell = Shell
    .value = SHELL
